#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "render/charts.hpp"
#include "render/contours.hpp"

using namespace asperity;
using namespace asperity::render;

namespace {

double area_of(const std::vector<std::vector<Vec2>>& polygons) {
  double area = 0;
  for (const auto& polygon : polygons)
    for (std::size_t i = 2; i < polygon.size(); ++i)
      area += 0.5 * std::abs(cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]));
  return area;
}

double bowl(double x, double y) { return x * x + y * y; }

}  // namespace

TEST_CASE("A plane has straight contours, exactly where it has the value") {
  const ScalarGrid grid = sample_grid({0, 2}, {0, 1}, 5, [](double x, double y) { return 3 * x + y; });
  const auto lines = contour_lines(grid, 2.5);
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].size() > 4);
  for (const Vec2 p : lines[0]) CHECK(3 * p.x + p.y == Approx(2.5));
}

TEST_CASE("A bowl has one closed contour near the circle") {
  const ScalarGrid grid = sample_grid({-1, 1}, {-1, 1}, 61, bowl);
  const auto lines = contour_lines(grid, 0.49);
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].front() == lines[0].back());
  // Along a diagonal of cells of h = 1/30 linear interpolation is off by at most f'' (2 h^2) / 8 = h^2 / 2 in the
  // value; the factor is for rounding where that is reached.
  for (const Vec2 p : lines[0]) CHECK(dot(p, p) == Approx(0.49).margin(0.5 / 900 * (1 + 1e-9)));
}

TEST_CASE("A saddle has two open contours") {
  const ScalarGrid grid = sample_grid({-1, 1}, {-1, 1}, 20, [](double x, double y) { return x * y; });
  CHECK(contour_lines(grid, 0.3).size() == 2);
  CHECK(contour_lines(grid, 2).empty());
}

TEST_CASE("The areas above and below a level make up the whole") {
  const ScalarGrid grid = sample_grid({-1, 1}, {-1, 1}, 61, bowl);
  const ScalarGrid negative = sample_grid({-1, 1}, {-1, 1}, 61, [](double x, double y) { return -bowl(x, y); });
  const double above = area_of(area_above(grid, 0.49)), below = area_of(area_above(negative, -0.49));
  CHECK(above + below == Approx(4));
  CHECK(below == Approx(3.14159265 * 0.49).epsilon(2e-3));
  CHECK(area_of(area_above(grid, -1)) == Approx(4));
  CHECK(area_above(grid, 3).empty());
}

TEST_CASE("Whole cells side by side are one rectangle") {
  const ScalarGrid grid = sample_grid({0, 1}, {0, 1}, 11, [](double, double) { return 1.0; });
  CHECK(area_above(grid, 0).size() == 10);
}

TEST_CASE("Values that are not finite are holes") {
  const ScalarGrid grid = sample_grid({-1, 1}, {-1, 1}, 41, [](double x, double y) {
    return x > 0.01 ? std::numeric_limits<double>::quiet_NaN() : bowl(x, y);
  });
  for (const auto& line : contour_lines(grid, 0.49))
    for (const Vec2 p : line) CHECK(p.x <= 0.05);
  CHECK(area_of(area_above(grid, -1)) == Approx(2));
}

TEST_CASE("Levels are round and inside the range") {
  CHECK(round_levels({0.03, 0.97}, 10) ==
        std::vector<double>{0.1, 0.2, 0.30000000000000004, 0.4, 0.5, 0.6000000000000001, 0.7000000000000001, 0.8, 0.9});
  CHECK(round_levels({5, 5}, 10) == std::vector<double>{5});
  CHECK(round_levels({}, 10) == std::vector<double>{0});
}
