#include "app/confrontation/chapters.hpp"

namespace asperity::app {
namespace {

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '|' || c == '*' || c == '<' || c == '>' || c == '`' || c == '[' || c == ']' || c == '\\' || c == '_')
      out += '\\';
    out += c == '\n' ? ' ' : c;
  }
  return out;
}

std::string address(const std::filesystem::path& path) { return html::linked_source(path); }

std::string table_line(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}

struct ToMarkup {
  html::Markup operator()(const Paragraph& p) const { return html::paragraph(p.text); }
  html::Markup operator()(const Bullets& b) const { return html::bullet_list({b.items.begin(), b.items.end()}); }
  html::Markup operator()(const Note& n) const { return html::notice(n.kind, n.text); }
  html::Markup operator()(const Entries& e) const {
    std::vector<html::Definition> entries;
    for (const auto& [term, meaning] : e.all) entries.push_back({term, meaning});
    return html::definition_list(entries);
  }
  html::Markup operator()(const PlainTable& t) const {
    html::Table table{t.caption, {}, {}};
    for (const PlainColumn& c : t.columns) table.columns.push_back({c.heading, c.unit, c.kind});
    for (const PlainRow& r : t.rows) table.rows.push_back({{r.cells.begin(), r.cells.end()}, r.tone});
    return html::table(table);
  }
  html::Markup operator()(const PlainFigure& f) const {
    html::Figure figure{{{html::linked_source(f.png), f.alternative_text}}, f.caption, {}};
    if (!f.svg.empty()) figure.links.push_back({f.svg, "SVG"});
    return html::figure(figure);
  }
  html::Markup operator()(const Files& files) const {
    std::vector<html::Markup> items;
    for (const auto& [path, what] : files.all) items.push_back(html::link(path, path.string()) + ": " + what);
    return html::bullet_list(items);
  }
};

struct ToMarkdown {
  std::string operator()(const Paragraph& p) const { return escaped(p.text) + "\n"; }
  std::string operator()(const Bullets& b) const {
    std::string text;
    for (const std::string& item : b.items) text += "* " + escaped(item) + "\n";
    return text;
  }
  std::string operator()(const Note& n) const {
    return std::string("> ") + (n.kind == html::NoticeKind::warning ? "**Warning:** " : "") + escaped(n.text) + "\n";
  }
  std::string operator()(const Entries& e) const {
    std::string text;
    for (const auto& [term, meaning] : e.all) text += "* **" + escaped(term) + "**: " + escaped(meaning) + "\n";
    return text;
  }
  std::string operator()(const PlainTable& t) const {
    std::vector<std::string> headings, rules;
    for (const PlainColumn& c : t.columns) {
      headings.push_back(escaped(c.heading) + (c.unit.empty() ? "" : " (" + escaped(c.unit) + ")"));
      rules.emplace_back(c.kind == html::ColumnKind::number ? "---:" : "---");
    }
    std::string text = t.caption.empty() ? "" : escaped(t.caption) + "\n\n";
    text += table_line(headings) + table_line(rules);
    for (const PlainRow& row : t.rows) {
      std::vector<std::string> cells;
      for (const std::string& cell : row.cells) cells.push_back(escaped(cell));
      cells.resize(t.columns.size());
      text += table_line(cells);
    }
    return text;
  }
  std::string operator()(const PlainFigure& f) const {
    return "![" + escaped(f.alternative_text) + "](" + address(f.png) + ")\n\n" + escaped(f.caption) + "\n";
  }
  std::string operator()(const Files& files) const {
    std::string text;
    for (const auto& [path, what] : files.all)
      text += "* [" + escaped(path.string()) + "](" + address(path) + "): " + escaped(what) + "\n";
    return text;
  }
};

}  // namespace

html::Markup markup_of(const Block& block) { return std::visit(ToMarkup{}, block); }

html::Section section_of(const Chapter& chapter) {
  html::Section section{chapter.title, {}, {}};
  for (const Block& block : chapter.blocks) section.parts.push_back(markup_of(block));
  return section;
}

std::string markdown_of(const Block& block) { return std::visit(ToMarkdown{}, block); }

std::string markdown_of(const Chapter& chapter) {
  std::string text = "## " + escaped(chapter.title) + "\n";
  for (const Block& block : chapter.blocks) text += "\n" + markdown_of(block);
  return text;
}

}  // namespace asperity::app
