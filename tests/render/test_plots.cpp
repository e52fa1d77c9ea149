#include <catch2/catch.hpp>
#include <limits>

#include "core/base/error.hpp"
#include "render/plots.hpp"
#include "render/style.hpp"
#include "tests/render/picture_file.hpp"

namespace fs = std::filesystem;
using namespace asperity;
using namespace asperity::render;

namespace {

Plot two_lines() {
  Plot plot;
  plot.title = "Stress & strain";
  plot.x_label = "Strain ε [10⁻³]";
  plot.y_label = "Axial stress σ₁ [MPa]";
  plot.series = {{"Axial", {0, 1, 2, 3}, {0, 5, 8, 2}, {}}, {"Lateral, ν < 0.5", {0, -1, -2}, {0, 5, 8}, {}}};
  return plot;
}

int occurrences(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

}  // namespace

TEST_CASE("A plot is written as PNG and SVG with the same lines") {
  const fs::path path = test::scratch("render_plot") / "stress_strain";
  write_plot(two_lines(), path);
  const test::PictureFile png = test::read_picture(path.string() + ".png");
  CHECK(png.width == 1600);
  CHECK(png.height == 1200);
  CHECK(png.count(style::kLines[0]) > 3000);
  CHECK(png.count(style::kLines[1]) > 1500);
  CHECK(png.count(style::kLines[2]) == 0);
  const std::string svg = test::file_bytes(path.string() + ".svg");
  CHECK(svg.find("viewBox=\"0 0 1600 1200\"") != std::string::npos);
  CHECK(svg.find("Axial stress σ₁ [MPa]</text>") != std::string::npos);
  CHECK(svg.find("Strain ε [10⁻³]</text>") != std::string::npos);
  CHECK(svg.find("Stress &amp; strain</text>") != std::string::npos);
  CHECK(svg.find("ν &lt; 0.5") != std::string::npos);
  CHECK(occurrences(svg, "stroke=\"#0072b2\"") == 2);  // line and legend
  CHECK(occurrences(svg, "stroke-dasharray=\"22 10\"") == 2);
}

TEST_CASE("Plots have the same bytes each time") {
  const fs::path folder = test::scratch("render_plot_repeat");
  write_plot(two_lines(), folder / "a");
  write_plot(two_lines(), folder / "b");
  CHECK(test::file_bytes(folder / "a.png") == test::file_bytes(folder / "b.png"));
  CHECK(test::file_bytes(folder / "a.svg") == test::file_bytes(folder / "b.svg"));
}

TEST_CASE("A value that is not finite breaks the line") {
  Plot plot = two_lines();
  plot.series = {{"", {0, 1, 2, 3, 4}, {0, 1, std::numeric_limits<double>::quiet_NaN(), 1, 0}, {}}};
  int lines = 0;
  for (const Shape& shape : draw_plot(plot).shapes)
    if (const Polyline* line = std::get_if<Polyline>(&shape)) lines += line->stroke.colour == style::kLines[0];
  CHECK(lines == 2);
}

TEST_CASE("Stacked areas add up") {
  Plot plot = two_lines();
  const SeriesStyle stacked{SeriesKind::stacked_area, VerticalAxis::left, {}};
  plot.series = {{"a", {0, 1}, {1, 1}, stacked}, {"b", {0, 1}, {2, 2}, stacked}};
  plot.y_range = Range{0, 4};
  std::vector<Band> bands;
  for (const Shape& shape : draw_plot(plot).shapes)
    if (const Band* band = std::get_if<Band>(&shape)) bands.push_back(*band);
  REQUIRE(bands.size() == 2);
  CHECK(bands[1].lower[0].y == bands[0].upper[0].y);
  const double one = bands[0].lower[0].y - bands[0].upper[0].y;
  CHECK(bands[1].lower[0].y - bands[1].upper[0].y == Approx(2 * one));
}

TEST_CASE("A plot without points is still a plot") {
  Plot plot = two_lines();
  plot.series.clear();
  const fs::path path = test::scratch("render_plot_empty") / "empty";
  write_plot(plot, path);
  CHECK(test::read_picture(path.string() + ".png").pixels.size() > 20);
}

TEST_CASE("A plot that cannot be written is an output error") {
  const fs::path folder = test::scratch("render_no_plot");
  fs::create_directories(folder / "x.svg");
  try {
    write_plot(two_lines(), folder / "x");
    FAIL("nothing was thrown");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::output);
  }
}
