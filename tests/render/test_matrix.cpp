#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/error.hpp"
#include "render/bar_panels.hpp"
#include "render/matrix_plot.hpp"
#include "render/paint.hpp"
#include "render/style.hpp"
#include "tests/render/picture_file.hpp"
#include "tests/render/text_checks.hpp"

using namespace asperity;
using namespace asperity::render;
using test::check_texts;
using test::kSmallestText;

namespace {

std::vector<std::string> names(std::size_t count) {
  static const std::vector<std::string> some{"platen_friction",    "frame_compliance", "out_of_plane_strips",
                                             "rate_strengthening", "crack_closure",    "seating"};
  std::vector<std::string> all;
  for (std::size_t i = 0; i < count; ++i)
    all.push_back(some[i % some.size()] + (i < some.size() ? "" : "_" + std::to_string(i)));
  return all;
}

/// Mostly right, with counts up to three digits, and a row of zeros.
MatrixPlot confusion(std::size_t count) {
  std::vector<std::vector<double>> counts(count, std::vector<double>(count, 0.0));
  for (std::size_t i = 0; i + 1 < count; ++i) {
    counts[i][i] = 96 + 40.0 * static_cast<double>(i % 3);
    counts[i][(i + 1) % count] = 3;
  }
  return confusion_matrix(names(count), names(count), counts);
}

std::vector<Colour> fills_of(const Drawing& drawing) {
  std::vector<Colour> fills;
  for (const Shape& shape : drawing.shapes)
    if (const auto* polygon = std::get_if<Polygon>(&shape)) fills.push_back(polygon->fill);
  return fills;
}

BarPanels bars(std::size_t rows, std::size_t panels) {
  BarPanels plot{"What is left, and what would make it", "In standard deviations.", "difference [–]", {}, {}, 2};
  for (std::size_t i = 0; i < rows; ++i)
    plot.rows.push_back(
        {"T" + std::to_string(i / 11), i % 2 == 0 ? "peak axial stress" : "dilation difference at peak"});
  for (std::size_t k = 0; k < panels; ++k) {
    plot.panels.push_back({names(panels)[k] + " × 0.83", {}, style::kBlue});
    for (std::size_t i = 0; i < rows; ++i)
      plot.panels.back().values.push_back(6 * std::sin(1.0 + 3.0 * static_cast<double>(i) + static_cast<double>(k)));
  }
  return plot;
}

}  // namespace

TEST_CASE("A confusion matrix keeps its texts apart from one cell to thirty by thirty") {
  for (const std::size_t count : {1U, 2U, 5U, 18U, 30U}) {
    CAPTURE(count);
    const Drawing drawing = draw_matrix(confusion(count));
    check_texts(drawing, kSmallestText);
    if (count > 1) CHECK(test::has_text(drawing, "96"));
    CHECK(test::has_text(drawing, "hidden"));
    CHECK(test::has_text(drawing, "named"));
  }
}

TEST_CASE("Cells have the colour of their share of the row, and an empty row none") {
  const MatrixPlot plot = confusion_matrix({"a", "b"}, {"a", "b", "none"}, {{3, 1, 0}, {0, 0, 0}});
  CHECK(plot.values[0][0] == 0.75);
  CHECK(plot.values[0][1] == 0.25);
  CHECK(std::isnan(plot.values[0][2]));
  CHECK(plot.texts[0] == std::vector<std::string>{"3", "1", ""});
  CHECK(std::isnan(plot.values[1][0]));
  CHECK(plot.row_notes == std::vector<std::string>{"n = 4", "n = 0"});
  const std::vector<Colour> fills = fills_of(draw_matrix(plot));
  CHECK(fills[0] == colour_at(plot.map, 0.75));
  CHECK(fills[1] == colour_at(plot.map, 0.25));
  CHECK(fills[2] == style::kPaper);
  CHECK(fills[3] == style::kPaper);
}

TEST_CASE("A right name is framed thickly, others are not") {
  const Drawing drawing = draw_matrix(confusion_matrix({"a", "b × 0.5"}, {"b", "none"}, {{1, 1}, {1, 1}}));
  int thick = 0;
  for (const Shape& shape : drawing.shapes)
    if (const auto* line = std::get_if<Polyline>(&shape)) thick += line->stroke.width >= 5;
  CHECK(thick == 4);  // four sides of one frame
}

TEST_CASE("Parts of a matrix that do not go together are refused") {
  CHECK_THROWS_AS(draw_matrix(confusion_matrix({"a"}, {"a", "b"}, {{1}})), Error);
  CHECK_THROWS_AS(draw_matrix(confusion_matrix({"a", "b"}, {"a"}, {{1}})), Error);
  CHECK_THROWS_AS(draw_matrix(confusion_matrix({}, {}, {})), Error);
}

TEST_CASE("Cosines stand in their cells with a sign") {
  const Drawing drawing = draw_matrix(cosine_matrix(names(3), {{1, -0.42, 0}, {-0.42, 1, 0.7}, {0, 0.7, 1}}));
  check_texts(drawing, kSmallestText);
  CHECK(test::has_text(drawing, "−0.42"));
}

TEST_CASE("A matrix is the same bytes each time") {
  const auto folder = test::scratch("render_matrix");
  write_png(draw_matrix(confusion(18)), folder / "a.png");
  write_png(draw_matrix(confusion(18)), folder / "b.png");
  CHECK(test::file_bytes(folder / "a.png") == test::file_bytes(folder / "b.png"));
}

TEST_CASE("Bars beside each other keep their texts apart and grow with their rows") {
  for (const std::size_t rows : {1U, 4U, 45U})
    for (const std::size_t panels : {1U, 2U, 4U}) {
      CAPTURE(rows, panels);
      check_texts(draw_bar_panels(bars(rows, panels)), kSmallestText);
    }
  CHECK(draw_bar_panels(bars(45, 2)).height > draw_bar_panels(bars(4, 2)).height + 41 * 30);
}

TEST_CASE("A bar reaches from zero as far as its value says, and a missing value has none") {
  BarPanels plot = bars(3, 1);
  plot.panels[0].values = {2, -4, NAN};
  const std::vector<Shape> shapes = draw_bar_panels(plot).shapes;
  std::vector<Box> boxes;
  for (const Shape& shape : shapes)
    if (const auto* p = std::get_if<Polygon>(&shape); p && p->fill == style::kBlue) {
      Box box{1e9, 0, -1e9, 0};
      for (const Vec2 c : p->corners) {
        box.left = std::min(box.left, c.x);
        box.right = std::max(box.right, c.x);
      }
      boxes.push_back(box);
    }
  REQUIRE(boxes.size() == 2);
  CHECK(boxes[0].left == Approx(boxes[1].right));
  CHECK(boxes[1].width() == Approx(2 * boxes[0].width()));
}
