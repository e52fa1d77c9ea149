#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/output/html.hpp"

/// A report's chapters as plain text in blocks, of which both a page and a Markdown file are made.
namespace asperity::app {

struct Paragraph {
  std::string text;
};

struct Bullets {
  std::vector<std::string> items;
};

struct Note {
  html::NoticeKind kind = html::NoticeKind::information;
  std::string text;
};

/// Terms with what they mean.
struct Entries {
  std::vector<std::pair<std::string, std::string>> all;
};

struct PlainRow {
  std::vector<std::string> cells;
  html::RowTone tone = html::RowTone::plain;
};

struct PlainColumn {
  std::string heading, unit;
  html::ColumnKind kind = html::ColumnKind::number;
};

struct PlainTable {
  std::string caption;
  std::vector<PlainColumn> columns;
  std::vector<PlainRow> rows;
};

/// A picture beside the page; `svg` empty: none.
struct PlainFigure {
  std::filesystem::path png, svg;
  std::string alternative_text, caption;
};

/// Files beside the page, each by its path and what it is.
struct Files {
  std::vector<std::pair<std::filesystem::path, std::string>> all;
};

using Block = std::variant<Paragraph, Bullets, Note, Entries, PlainTable, PlainFigure, Files>;

struct Chapter {
  std::string title;
  std::vector<Block> blocks;
};

html::Markup markup_of(const Block& block);
html::Section section_of(const Chapter& chapter);

/// Markdown as GitHub and others read it; what would be markup in a text is escaped.
std::string markdown_of(const Block& block);
std::string markdown_of(const Chapter& chapter);

}  // namespace asperity::app
