#include "core/output/html_sortable.hpp"

#include <catch2/catch.hpp>

using namespace asperity;

namespace {

std::size_t count(std::string_view text, std::string_view part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("A sortable table is the table, with a hidden filter box that only the script shows") {
  const html::Table table{"caption", {{"Run", {}, html::ColumnKind::head}, {"Strength", "MPa"}}, {{{"a<b", "1.5"}}}};
  const std::string html = html::sortable_table(table, "runs & more").html();
  CHECK(html.find(html::table(table).html()) != std::string::npos);
  CHECK(count(html, "<div") == count(html, "</div>"));
  CHECK(html.find("controls\" hidden><label>") != std::string::npos);
  CHECK(html.find("data-rows=\"runs &amp; more\"") != std::string::npos);
  const std::string_view script = html::sortable_table_script();
  for (const char* needed : {"aria-sort", ".filter", "createElement(\"button\")", "row.hidden"})
    CHECK(script.find(needed) != std::string_view::npos);
  CHECK(script.find("</") == std::string_view::npos);
}

TEST_CASE("A thumbnail is a link with a picture that says what it shows") {
  const std::string html = html::thumbnail({"a/b.png", "the \"last\" one"}, "a b/report.html").html();
  CHECK(html.find("href=\"a%20b/report.html\"") != std::string::npos);
  CHECK(html.find("src=\"a/b.png\" alt=\"the &quot;last&quot; one\"") != std::string::npos);
}
