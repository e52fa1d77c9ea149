#include <catch2/catch.hpp>
#include <cmath>

#include "render/charts.hpp"
#include "render/rose_plot.hpp"
#include "render/style.hpp"
#include "tests/render/text_checks.hpp"

using namespace asperity;
using namespace asperity::render;
using test::check_texts;
using test::kSmallestText;

namespace {

RosePlot two_roses() {
  RosePlot plot;
  plot.title = "Directions of the cracks";
  plot.caption = "Crack length by direction; a sector's area is its share.";
  plot.axis_label = "load";
  plot.roses = {{"Tension: 12 cracks, 20 mm", std::vector<double>(18, 1.0), style::kTension},
                {"Shear: 3 cracks, 4 mm", std::vector<double>(18, 0.0), style::kShear}};
  plot.roses[1].sectors[6] = 4.0;  // from 60 to 70 degrees
  return plot;
}

std::vector<Polygon> wedges_of(const Drawing& drawing, Colour fill) {
  std::vector<Polygon> wedges;
  for (const Shape& shape : drawing.shapes)
    if (const auto* polygon = std::get_if<Polygon>(&shape); polygon && polygon->fill == fill)
      wedges.push_back(*polygon);
  return wedges;
}

double reach(const Polygon& wedge) { return norm(wedge.corners[3] - wedge.corners[0]); }

}  // namespace

TEST_CASE("A rose has its sectors at both ends of a direction, with areas that are shares") {
  const Drawing drawing = draw_roses(two_roses());
  const auto tension = wedges_of(drawing, style::kTension), shear = wedges_of(drawing, style::kShear);
  REQUIRE(tension.size() == 36);
  REQUIRE(shear.size() == 2);
  // Shares 1/18 and 1: radii as 1 to sqrt(18).
  CHECK(reach(shear[0]) / reach(tension[0]) == Approx(std::sqrt(18.0)).epsilon(1e-9));
  const Vec2 middle = shear[0].corners[4] - shear[0].corners[0];  // of seven corners of the arc
  const double degrees = std::atan2(-middle.y, middle.x) * 180 / 3.14159265358979;
  CHECK(degrees == Approx(65.0).margin(0.01));  // y is downwards in a drawing
  const Vec2 opposite = shear[1].corners[4] - shear[1].corners[0];
  CHECK(opposite.x == Approx(-middle.x).margin(1e-6));
  CHECK(opposite.y == Approx(-middle.y).margin(1e-6));
}

TEST_CASE("A rose's texts are clear of one another, for an upright and a level direction, and without cracks") {
  check_texts(draw_roses(two_roses()), kSmallestText);
  RosePlot joint = two_roses();
  joint.axis_deg = 0;
  joint.axis_label = "joint";
  check_texts(draw_roses(joint), kSmallestText);
  joint.roses[1].sectors.assign(18, 0.0);
  check_texts(draw_roses(joint), kSmallestText);
}

TEST_CASE("A logarithmic axis carries the numbers of its decadic logarithms") {
  Chart chart;
  chart.x_label = "size [mm]";
  chart.y_label = "number [–]";
  chart.layers.emplace_back(LineLayer{"line", {-1, 2}, {0, 4}, {style::kBlue, 4, {}, Cap::butt}});
  chart.x_log = chart.y_log = true;
  chart.x_range = Range{-0.4, 1.2};
  chart.y_range = Range{0, 5};
  ChartFigure figure;
  figure.title = "Title";
  figure.charts = {chart};
  const Drawing drawing = draw_figure(figure);
  for (const char* tick : {"0.5", "1", "2", "5", "10", "100", "1000", "10⁴", "10⁵"}) {
    CAPTURE(tick);
    CHECK(test::has_text(drawing, tick));
  }
  check_texts(drawing, kSmallestText);
}
