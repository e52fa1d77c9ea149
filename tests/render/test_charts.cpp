#include <catch2/catch.hpp>
#include <limits>

#include "render/chart_layers.hpp"
#include "render/charts.hpp"
#include "render/paint.hpp"
#include "render/style.hpp"
#include "render/text_runs.hpp"
#include "tests/render/picture_file.hpp"
#include "tests/render/text_checks.hpp"

using namespace asperity;
using namespace asperity::render;
using test::check_texts;
using test::kSmallestText;

namespace {

Chart small_chart() {
  Chart chart{"Heading", "strain ε [%]", "stress σ_{t} [MPa]", {}, {}, {}, {}};
  chart.layers.emplace_back(LineLayer{"line", {0, 1, 2}, {0, 3, 1}, {style::kBlue, 4, {}, Cap::butt}});
  chart.layers.emplace_back(PointLayer{
      "points", {0, 1, 2}, {1, 2, 3}, {MarkerShape::ring, style::kVermilion, 8}, {}, {0.5, 0.5, 0.5}, {"a", "", "c"}});
  return chart;
}

ChartFigure figure_of(std::vector<Chart> charts, int columns) {
  ChartFigure figure;
  figure.title = "Title";
  figure.caption =
      "A caption that says what is held and what the reader should look at, long enough to need two lines of "
      "text under the charts, as captions often do.";
  figure.charts = std::move(charts);
  figure.columns = columns;
  return figure;
}

/// The frames' corners as the charts draw them: the longest lines in ink that are level.
std::vector<Vec2> frame_tops(const Drawing& drawing) {
  std::vector<Vec2> tops;
  for (const Shape& shape : drawing.shapes) {
    const auto* line = std::get_if<Polyline>(&shape);
    if (!line || line->points.size() != 2 || !(line->stroke.colour == style::kInk)) continue;
    if (line->points[0].y == line->points[1].y && line->points[1].x - line->points[0].x > 200)
      tops.push_back(line->points[0]);
  }
  return tops;
}

}  // namespace

TEST_CASE("Indices are lowered runs between their neighbours") {
  const auto runs = runs_of("σ_{t} [MPa]", 30, Weight::regular);
  REQUIRE(runs.size() == 3);
  CHECK(runs[1].text == "t");
  CHECK(runs[1].size < 30);
  CHECK(runs[1].below > 0);
  CHECK(runs[2].below == 0);
  CHECK(runs[1].along > runs[0].along);
  CHECK(runs[2].along > runs[1].along);
  CHECK(unmarked("σ_{t} [MPa]") == "σt [MPa]");
  CHECK(runs_of("a_b", 30, Weight::regular).size() == 1);
  CHECK(text_width("t_{c}", 30) > text_width("t", 30));
  CHECK(text_width("t_{c}", 30) < text_width("tc", 30) + 1);
}

TEST_CASE("An index is a tspan in SVG and goes back up after it") {
  const auto path = test::scratch("render_index") / "index.svg";
  Drawing drawing{400, 100, {}};
  drawing.shapes.push_back(
      Text{{20, 60}, "σ_{<} x", 30, Anchor::left, Weight::regular, Direction::across, style::kInk});
  write_svg(drawing, path);
  const std::string svg = test::file_bytes(path);
  CHECK(svg.find(">σ<tspan dy=\"5.40\" font-size=\"22.8\">&lt;</tspan><tspan dy=\"-5.40\"> x</tspan></text>") !=
        std::string::npos);
}

TEST_CASE("Text is wrapped at blanks") {
  const auto lines = wrapped("one two three four", 24, text_width("one two", 24) + 1);
  CHECK(lines == std::vector<std::string>{"one two", "three", "four"});
  CHECK(wrapped("", 24, 100).empty());
}

TEST_CASE("Lines are cut at the frame") {
  const Box box{0, 0, 10, 10};
  const auto parts = clipped({{-5, 5}, {5, 5}, {5, 20}, {20, 20}, {8, 20}, {8, 8}}, box);
  REQUIRE(parts.size() == 2);
  CHECK(parts[0] == std::vector<Vec2>{{0, 5}, {5, 5}, {5, 10}});
  CHECK(parts[1] == std::vector<Vec2>{{8, 10}, {8, 8}});
}

TEST_CASE("Nothing of a chart's data lies outside its frame") {
  Chart chart = small_chart();
  chart.x_range = Range{0.5, 1.5};
  chart.y_range = Range{1.5, 2.2};
  chart.layers.emplace_back(BandLayer{"", {0, 1, 2}, {0, 0, 0}, {9, 9, 9}, style::kOrange});
  chart.layers.emplace_back(BoxLayer{"", {-5, 5}, {-5, 5}, style::kSky, Stroke{style::kSky, 3, {}, Cap::butt}});
  const Drawing drawing = draw_figure(figure_of({chart}, 1));
  const auto tops = frame_tops(drawing);
  REQUIRE(tops.size() >= 2);
  for (const Shape& shape : drawing.shapes)
    if (const auto* band = std::get_if<Band>(&shape))
      for (const Vec2 p : band->upper) CHECK(p.y >= tops[0].y - 1);
}

TEST_CASE("Frames of a figure are aligned along rows and columns and of one size") {
  Chart wide = small_chart();
  wide.y_range = Range{1e4, 2e4};
  const auto tops = frame_tops(draw_figure(figure_of({small_chart(), small_chart(), wide, small_chart()}, 2)));
  REQUIRE(tops.size() == 8);  // top and bottom of four frames
  CHECK(tops[0].y == tops[2].y);
  CHECK(tops[0].x == tops[4].x);
  CHECK(tops[2].x == tops[6].x);
  CHECK(tops[1].y - tops[0].y == Approx(tops[5].y - tops[4].y).margin(1));
}

TEST_CASE("Texts of figures with one to six charts are whole, apart and readable") {
  for (const int count : {1, 2, 3, 6}) {
    ChartFigure figure =
        figure_of(std::vector<Chart>(static_cast<std::size_t>(count), small_chart()), std::min(count, 3));
    figure.letters = Letters::each;
    CAPTURE(count);
    const Drawing drawing = draw_figure(figure);
    check_texts(drawing, kSmallestText);
    CHECK(test::has_text(drawing, "(a) Heading"));
    CHECK(test::has_text(drawing, "line"));
  }
}

TEST_CASE("A layer's label stands in the legend once for all charts") {
  int times = 0;
  for (const Text& text : test::texts_of(draw_figure(figure_of({small_chart(), small_chart()}, 2))))
    times += text.text == "points";
  CHECK(times == 1);
}

TEST_CASE("Values that are not finite are left out, and an empty figure is still a figure") {
  const double none = std::numeric_limits<double>::quiet_NaN();
  Chart chart = small_chart();
  chart.layers.emplace_back(PointLayer{"", {none, 1}, {1, none}, {MarkerShape::disc, style::kGreen, 8}, {}, {}, {}});
  for (const Shape& shape : draw_figure(figure_of({chart}, 1)).shapes)
    if (const auto* polygon = std::get_if<Polygon>(&shape)) CHECK_FALSE(polygon->fill == style::kGreen);
  CHECK(test::has_text(draw_figure(figure_of({}, 1)), "Title"));
}

TEST_CASE("Names of points stay clear of markers and of one another") {
  Chart chart{"", "x [–]", "y [–]", {}, {}, {}, {}};
  PointLayer crowd{"crowd", {}, {}, {MarkerShape::disc, style::kBlue, 8}, {}, {}, {}};
  for (int i = 0; i < 6; ++i) {
    crowd.x.push_back(0.01 * i);
    crowd.y.push_back(0.01 * (i % 2));
    crowd.names.push_back("run " + std::to_string(i));
  }
  crowd.x.push_back(1);
  crowd.y.push_back(1);
  chart.layers.emplace_back(crowd);
  check_texts(draw_figure(figure_of({chart}, 1)), kSmallestText);
}

TEST_CASE("Every marker shape is drawn in its colour") {
  using enum MarkerShape;
  for (const MarkerShape shape : {disc, ring, square, open_square, diamond, open_diamond, triangle, star, cross}) {
    Drawing drawing{40, 40, {}};
    add_marker(drawing, {20, 20}, {shape, style::kGreen, 8});
    bool coloured = false;
    for (const Shape& part : drawing.shapes) {
      if (const auto* polygon = std::get_if<Polygon>(&part)) coloured = coloured || polygon->fill == style::kGreen;
      if (const auto* line = std::get_if<Polyline>(&part)) coloured = coloured || line->stroke.colour == style::kGreen;
    }
    CHECK(coloured);
  }
}

TEST_CASE("Names of points stay clear of lines where there is room") {
  Chart chart{"", "x [–]", "y [–]", {}, Range{0, 2}, Range{0, 2}, {}};
  // A level line through the point: beside it, where a name stands first, it would lie on the line.
  chart.layers.emplace_back(LineLayer{"line", {0, 2}, {1, 1}, {style::kBlue, 4, {}, Cap::butt}});
  chart.layers.emplace_back(PointLayer{"", {1}, {1}, {MarkerShape::ring, style::kInk, 7}, {}, {}, {"peak"}});
  const Drawing drawing = draw_figure(figure_of({chart}, 1));
  double line = 0;
  for (const Shape& shape : drawing.shapes)
    if (const auto* p = std::get_if<Polyline>(&shape); p && p->stroke.colour == style::kBlue)
      line = p->points.back().y;  // the last one is the chart's, the first the legend's
  for (const Text& text : test::texts_of(drawing)) {
    if (text.text != "peak") continue;
    const Box box = text_box(text);
    CHECK((box.bottom < line || box.top > line));
  }
  CHECK(test::has_text(drawing, "peak"));
}

TEST_CASE("Arrowheads point the way a line goes") {
  Chart chart{"", "x [–]", "y [–]", {}, Range{0, 2}, Range{0, 2}, {}};
  chart.layers.emplace_back(
      LineLayer{"line", {0.5, 1.5, 0.5}, {1, 1, 1}, {style::kGreen, 4, {}, Cap::butt}, 0, {1, 2}});
  std::vector<Triangle> heads;
  for (const Shape& shape : draw_figure(figure_of({chart}, 1)).shapes)
    if (const auto* t = std::get_if<Triangle>(&shape); t && t->fill == style::kGreen) heads.push_back(*t);
  REQUIRE(heads.size() == 2);
  CHECK(heads[0].corners[0].x > heads[0].corners[1].x);  // to the right, then back
  CHECK(heads[1].corners[0].x < heads[1].corners[1].x);
}

TEST_CASE("Ticks are fewer where their labels would touch") {
  Chart chart{"", "slip [mm]", "y [–]", {}, Range{0, 0.0244}, Range{0, 1}, {}};
  chart.layers.emplace_back(LineLayer{"line", {0, 0.0244}, {0, 1}, {style::kBlue, 4, {}, Cap::butt}});
  ChartFigure figure = figure_of({chart, chart}, 2);
  figure.width = 2000;
  check_texts(draw_figure(figure), kSmallestText);
}
