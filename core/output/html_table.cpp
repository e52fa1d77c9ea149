#include <fmt/format.h>

#include "core/output/html.hpp"

namespace asperity::html {
namespace {

const char* class_of(ColumnKind kind) {
  if (kind == ColumnKind::prose) return " class=\"prose\"";
  return kind == ColumnKind::number ? " class=\"number\"" : "";
}

const char* class_of(RowTone tone) {
  switch (tone) {
    case RowTone::plain:
      return "";
    case RowTone::good:
      return " class=\"good\"";
    case RowTone::bad:
      return " class=\"bad\"";
    case RowTone::quiet:
      return " class=\"quiet\"";
  }
  return "";
}

std::string heading(const Column& column) {
  const std::string unit =
      column.unit.empty() ? "" : fmt::format("<br><span class=\"unit\">{}</span>", column.unit.html());
  return fmt::format("<th scope=\"col\"{}>{}{}</th>", class_of(column.kind), column.heading.html(), unit);
}

std::string cell(const Column& column, const Markup& content) {
  if (column.kind == ColumnKind::head) return "<th scope=\"row\">" + content.html() + "</th>";
  return fmt::format("<td{}>{}</td>", class_of(column.kind), content.html());
}

std::string row(const std::vector<Column>& columns, const Row& row) {
  std::string out = fmt::format("<tr{}>", class_of(row.tone));
  for (std::size_t i = 0; i < columns.size(); ++i) out += cell(columns[i], i < row.cells.size() ? row.cells[i] : "");
  return out + "</tr>\n";
}

}  // namespace

Markup table(const Table& table) {
  // The frame scrolls by itself where the window is narrow; the keyboard reaches it.
  std::string out = "<div class=\"wide\" tabindex=\"0\">\n<table>\n";
  if (!table.caption.empty()) out += "<caption>" + table.caption.html() + "</caption>\n";
  out += "<thead><tr>";
  for (const Column& column : table.columns) out += heading(column);
  out += "</tr></thead>\n<tbody>\n";
  for (const Row& r : table.rows) out += row(table.columns, r);
  return Markup::from_html(out + "</tbody>\n</table>\n</div>\n");
}

}  // namespace asperity::html
