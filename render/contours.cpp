#include "render/contours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

namespace asperity::render {
namespace {

struct Corner {
  std::size_t index;  ///< In the grid's values.
  Vec2 at;
  double value;
};

using Cell = std::array<Corner, 3>;

Corner corner(const ScalarGrid& grid, std::size_t i, std::size_t j) {
  return {j * grid.x.size() + i, grid.point(i, j), grid.at(i, j)};
}

std::array<Cell, 2> triangles_of(const ScalarGrid& grid, std::size_t i, std::size_t j) {
  const Corner a = corner(grid, i, j), b = corner(grid, i + 1, j), c = corner(grid, i + 1, j + 1),
               d = corner(grid, i, j + 1);
  return {Cell{a, b, c}, Cell{a, c, d}};
}

bool finite(const Cell& cell) {
  return std::all_of(cell.begin(), cell.end(), [](const Corner& c) { return std::isfinite(c.value); });
}

Vec2 crossing(const Corner& a, const Corner& b, double level) {
  return a.at + ((level - a.value) / (b.value - a.value)) * (b.at - a.at);
}

/// A grid edge by the numbers of its ends, the lower one first.
using Edge = std::pair<std::size_t, std::size_t>;

/// The points where the line crosses grid edges, and which of them follow one another.
struct Crossings {
  std::map<Edge, Vec2> points;
  std::map<Edge, std::vector<Edge>> neighbours;
};

void add_crossings(const Cell& cell, double level, Crossings& crossings) {
  std::vector<Edge> crossed;
  for (std::size_t k = 0; k < 3; ++k) {
    const Corner *a = &cell[k], *b = &cell[(k + 1) % 3];
    if ((a->value >= level) == (b->value >= level)) continue;
    if (a->index > b->index) std::swap(a, b);
    crossed.emplace_back(a->index, b->index);
    crossings.points.emplace(crossed.back(), crossing(*a, *b, level));
  }
  if (crossed.size() != 2) return;
  crossings.neighbours[crossed[0]].push_back(crossed[1]);
  crossings.neighbours[crossed[1]].push_back(crossed[0]);
}

/// Follows the line from an edge and forgets what it has passed.
std::vector<Vec2> follow(Edge edge, Crossings& crossings) {
  std::vector<Vec2> line{crossings.points.at(edge)};
  const auto forget = [&](const Edge& from, const Edge& to) { std::erase(crossings.neighbours[from], to); };
  while (!crossings.neighbours[edge].empty()) {
    const Edge next = crossings.neighbours[edge].front();
    forget(edge, next);
    forget(next, edge);
    line.push_back(crossings.points.at(next));
    edge = next;
  }
  return line;
}

/// What lies at or above the level of a triangle: nothing, or 3 to 4 corners.
std::vector<Vec2> part_above(const Cell& cell, double level) {
  std::vector<Vec2> part;
  for (std::size_t k = 0; k < 3; ++k) {
    const Corner &a = cell[k], &b = cell[(k + 1) % 3];
    if (a.value >= level) part.push_back(a.at);
    if ((a.value >= level) != (b.value >= level)) part.push_back(crossing(a, b, level));
  }
  return part;
}

bool whole_cell_above(const ScalarGrid& grid, std::size_t i, std::size_t j, double level) {
  return std::min({grid.at(i, j), grid.at(i + 1, j), grid.at(i, j + 1), grid.at(i + 1, j + 1)}) >= level &&
         std::isfinite(grid.at(i, j) + grid.at(i + 1, j) + grid.at(i, j + 1) + grid.at(i + 1, j + 1));
}

void add_row(const ScalarGrid& grid, std::size_t j, double level, std::vector<std::vector<Vec2>>& area) {
  for (std::size_t i = 0; i + 1 < grid.x.size(); ++i) {
    const std::size_t first = i;
    while (i + 1 < grid.x.size() && whole_cell_above(grid, i, j, level)) ++i;
    if (i > first)
      area.push_back({grid.point(first, j), grid.point(i, j), grid.point(i, j + 1), grid.point(first, j + 1)});
    if (i + 1 == grid.x.size()) return;
    for (const Cell& cell : triangles_of(grid, i, j)) {
      if (!finite(cell)) continue;
      std::vector<Vec2> part = part_above(cell, level);
      if (part.size() > 2) area.push_back(std::move(part));
    }
  }
}

}  // namespace

std::vector<std::vector<Vec2>> contour_lines(const ScalarGrid& grid, double level) {
  Crossings crossings;
  for (std::size_t j = 0; j + 1 < grid.y.size(); ++j)
    for (std::size_t i = 0; i + 1 < grid.x.size(); ++i)
      for (const Cell& cell : triangles_of(grid, i, j))
        if (finite(cell)) add_crossings(cell, level, crossings);
  std::vector<Edge> ends, others;
  for (const auto& [edge, next] : crossings.neighbours) (next.size() == 1 ? ends : others).push_back(edge);
  ends.insert(ends.end(), others.begin(), others.end());  // open lines from their ends first, then rings
  std::vector<std::vector<Vec2>> lines;
  for (const Edge& edge : ends)
    if (!crossings.neighbours[edge].empty()) lines.push_back(follow(edge, crossings));
  return lines;
}

std::vector<std::vector<Vec2>> area_above(const ScalarGrid& grid, double level) {
  std::vector<std::vector<Vec2>> area;
  for (std::size_t j = 0; j + 1 < grid.y.size(); ++j) add_row(grid, j, level, area);
  return area;
}

}  // namespace asperity::render
