#pragma once
#include <vector>

#include "core/base/vec2.hpp"
#include "render/range.hpp"

namespace asperity::render {

/// A quantity over two variables, on the points of a grid. A value that is not finite is a hole.
struct ScalarGrid {
  std::vector<double> x, y;    ///< Ascending, at least two each.
  std::vector<double> values;  ///< x.size() * y.size(), x running fastest.
  double at(std::size_t i, std::size_t j) const { return values[j * x.size() + i]; }
  Vec2 point(std::size_t i, std::size_t j) const { return {x[i], y[j]}; }
};

/// The grid with value(x, y) at `points` places along each range.
template <class Function>
ScalarGrid sample_grid(Range x, Range y, int points, const Function& value) {
  ScalarGrid grid;
  for (int i = 0; i < points; ++i) {
    const double part = static_cast<double>(i) / (points - 1);
    grid.x.push_back(x.low + part * (x.high - x.low));
    grid.y.push_back(y.low + part * (y.high - y.low));
  }
  for (const double v : grid.y)
    for (const double u : grid.x) grid.values.push_back(value(u, v));
  return grid;
}

/// Where the quantity has this value: open or closed (first point = last) lines in x and y. Between grid points it is
/// linear over two triangles a cell.
std::vector<std::vector<Vec2>> contour_lines(const ScalarGrid& grid, double level);

/// The area where the quantity is at or above this value, as convex polygons in x and y; whole cells side by side are
/// one rectangle.
std::vector<std::vector<Vec2>> area_above(const ScalarGrid& grid, double level);

}  // namespace asperity::render
