#include "core/output/html.hpp"

#include <catch2/catch.hpp>

using namespace asperity;
using namespace asperity::html;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::size_t place(const std::string& text, const std::string& part) { return text.find(part); }

int occurrences(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

Page small_page() {
  return {"A & B",
          "subtitle",
          {notice(NoticeKind::warning, "read <this>")},
          {{"First", {paragraph("one")}, {{"Inner", {paragraph("two")}, {{"Deeper", {}, {}}}}}},
           {"Second", {}, {}},
           {"First", {}, {}}},
          "foot"};
}

}  // namespace

TEST_CASE("Text is escaped on its way into a page") {
  CHECK(Markup("<b> & \"c\" 'd'").html() == "&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;");
  CHECK(escaped(std::string("a\x01"
                            "b\n\t")) ==
        "a\xEF\xBF\xBD"
        "b\n\t");
  CHECK(escaped("σ_t ≥ 1") == "σ_t ≥ 1");
  CHECK(paragraph("<script>").html() == "<p>&lt;script&gt;</p>");
  CHECK((Markup("a<") + strong("b")).html() == "a&lt;<strong>b</strong>");
  CHECK(contains(document(small_page()), "read &lt;this&gt;"));
  CHECK(contains(document(small_page()), "<title>A &amp; B</title>"));
}

TEST_CASE("Numbers have significant digits, true minus signs and raised powers") {
  CHECK(number(1.3).html() == "1.300");
  CHECK(number(2504).html() == "2504");
  CHECK(number(25041.7).html() == "25042");
  CHECK(number(-0.01234, 3).html() == "−0.0123");
  CHECK(number(0.99996).html() == "1.000");
  CHECK(number(0).html() == "0");
  CHECK(number(6.18e-7, 2).html() == "6.2×10<sup>−7</sup>");
  CHECK(number(1.5e9, 2).html() == "1.5×10<sup>9</sup>");
  CHECK(number(NAN).html() == "–");
  CHECK(number(INFINITY).html() == "–");
  CHECK(fixed(-0.04, 1).html() == "0.0");
  CHECK(as_given(1.6).html() == "1.6");
  CHECK(as_given(40).html() == "40");
  CHECK(as_given(-1.682).html() == "−1.682");
}

TEST_CASE("A mean ends where its standard deviation does") {
  CHECK(with_scatter(1.32714, 0.02212).html() == "1.327 ± 0.022");
  CHECK(with_scatter(40.618, 0.54).html() == "40.62 ± 0.54");
  CHECK(with_scatter(1234.5, 56).html() == "1234 ± 56");
  CHECK(with_scatter(1.5, NAN).html() == "1.500");
  CHECK(with_scatter(1.5, 0).html() == "1.500");
  CHECK(with_scatter(NAN, 0.1).html() == "–");
}

TEST_CASE("Formulas have indices, exponents and italic variables") {
  CHECK(formula("x_1^2").html() == "<span class=\"formula\"><i>x</i><sub>1</sub><sup>2</sup></span>");
  CHECK(formula("S_{LOF} < 1").html() == "<span class=\"formula\"><i>S</i><sub>LOF</sub> &lt; 1</span>");
  CHECK(formula("β_φ").html() == "<span class=\"formula\">β<sub>φ</sub></span>");
  CHECK(formula("a_").html() == "<span class=\"formula\"><i>a</i>_</span>");
  CHECK(formula("a_{b").html() == "<span class=\"formula\"><i>a</i><sub>{</sub><i>b</i></span>");
  CHECK(with_indices("t_{c} a_b^2").html() == "t<sub>c</sub> a_b^2");
}

TEST_CASE("Links stay beside the page") {
  CHECK(html::link("plots/a b#1.svg", "x").html() == "<a href=\"plots/a%20b%231.svg\">x</a>");
  CHECK(linked_source("javascript:alert(1)") == "javascript%3Aalert%281%29");
  CHECK(linked_source("σ.png") == "%CF%83.png");
}

TEST_CASE("Base64 has its paddings") {
  CHECK(embedded_source("Man", "image/png") == "data:image/png;base64,TWFu");
  CHECK(embedded_source("Ma", "image/png") == "data:image/png;base64,TWE=");
  CHECK(embedded_source("M", "image/png") == "data:image/png;base64,TQ==");
  CHECK(embedded_source("", "image/png") == "data:image/png;base64,");
  CHECK(embedded_source(std::string("\xFF\xFE\x00\x01", 4), "x/y") == "data:x/y;base64,//4AAQ==");
}

TEST_CASE("A table has heads with units, a cell for every column and tones") {
  const Table given{"Cap <1>",
                    {{"Property", {}, ColumnKind::head}, {"E", "GPa"}, {"Why", {}, ColumnKind::text}},
                    {{{"a", number(1.3)}, RowTone::bad}, {{"b", number(2), "because"}, RowTone::good}}};
  const std::string html = html::table(given).html();
  CHECK(contains(html, "<caption>Cap &lt;1&gt;</caption>"));
  CHECK(contains(html, "<th scope=\"col\" class=\"number\">E<br><span class=\"unit\">GPa</span></th>"));
  CHECK(contains(html, "<tr class=\"bad\"><th scope=\"row\">a</th><td class=\"number\">1.300</td><td></td></tr>"));
  CHECK(contains(html, "<tr class=\"good\">"));
}

TEST_CASE("A figure has its alternative text, caption and links") {
  const std::string html =
      figure({{{linked_source("plots/a.png"), "A \"plot\""}, {embedded_source("x", "image/png"), "B"}},
              "caption",
              {{"plots/a.svg", "SVG"}}})
          .html();
  CHECK(contains(html,
                 "<a href=\"plots/a.png\"><img src=\"plots/a.png\" alt=\"A &quot;plot&quot;\" loading=\"lazy\"></a>"));
  CHECK(contains(html, "<img src=\"data:image/png;base64,eA==\" alt=\"B\""));
  CHECK(contains(html, "<figcaption>caption <a href=\"plots/a.svg\">SVG</a></figcaption>"));
}

TEST_CASE("Headings follow the nesting, anchors differ, and the contents name the sections") {
  const std::string html = document(small_page());
  CHECK(occurrences(html, "<h1>") == 1);
  CHECK(contains(html, "<h2>First</h2>"));
  CHECK(contains(html, "<h3>Inner</h3>"));
  CHECK(contains(html, "<h4>Deeper</h4>"));
  CHECK(occurrences(html, "id=\"first\"") == 1);
  CHECK(occurrences(html, "id=\"first-2\"") == 1);
  CHECK(contains(html, "<li><a href=\"#second\">Second</a></li>"));
  CHECK_FALSE(contains(html, "href=\"#inner\""));
  CHECK(place(html, "class=\"notice warning\"") < place(html, "<nav"));
}

TEST_CASE("A page needs no script and no network and knows dark mode and print") {
  const std::string html = document(small_page());
  CHECK_FALSE(contains(html, "<script"));
  CHECK_FALSE(contains(html, "http"));
  CHECK_FALSE(contains(html, "@import"));
  CHECK_FALSE(contains(html, "url("));
  CHECK(contains(html, "prefers-color-scheme: dark"));
  CHECK(contains(html, "@media print"));
  CHECK(contains(html, "<html lang=\"en\">"));
  CHECK(contains(html, "charset=\"utf-8\""));
}
