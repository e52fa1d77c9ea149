#include "core/geometry/grains.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.hpp"
#include "core/geometry/border_graph.hpp"
#include "core/geometry/triangulation.hpp"

namespace asperity {
namespace {

/// The centres, then their images beyond every side nearer than `reach`: the Voronoi borders between a centre and its
/// own image then lie on the side (exactly for a straight one).
std::vector<Vec2> with_images(const Outline& outline, const std::vector<Vec2>& centres, double reach) {
  std::vector<Vec2> all = centres;
  for (const Vec2& p : centres)
    for (const Side& side : outline.sides) {
      const SidePoint foot = side.nearest(p);
      const bool beside = foot.along > 0.0 && foot.along < side.length();
      if (beside && norm(foot.point - p) < reach) all.push_back(2.0 * foot.point - p);
    }
  return all;
}

Vec2 circumcentre(Vec2 a, Vec2 b, Vec2 c) {
  const Vec2 u = b - a, v = c - a;
  const double scale = 0.5 / cross(u, v), uu = dot(u, u), vv = dot(v, v);
  return a + scale * Vec2{uu * v.y - vv * u.y, vv * u.x - uu * v.x};
}

std::vector<Vec2> circumcentres(const std::vector<Vec2>& points, const Triangulation& mesh) {
  std::vector<Vec2> centres;
  for (const auto& [a, b, c] : mesh.triangles) centres.push_back(circumcentre(points[a], points[b], points[c]));
  return centres;
}

/// Of a polygon around `origin` whose corners come in any order; origin itself where the polygon has no area.
Vec2 centroid_around(Vec2 origin, std::vector<Vec2> corners) {
  const auto angle = [&](Vec2 p) { return std::atan2(p.y - origin.y, p.x - origin.x); };
  std::sort(corners.begin(), corners.end(), [&](Vec2 p, Vec2 q) { return angle(p) < angle(q); });
  double area = 0.0;
  Vec2 moment{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 u = corners[i] - origin, v = corners[(i + 1) % corners.size()] - origin;
    area += cross(u, v);
    moment += (cross(u, v) / 3.0) * (u + v);
  }
  return area > 0.0 ? origin + (1.0 / area) * moment : origin;
}

/// Eq. (G5).
void lloyd_step(const Outline& outline, const std::vector<Vec2>& polygon, double reach, std::vector<Vec2>& centres) {
  const std::vector<Vec2> points = with_images(outline, centres, reach);
  const Triangulation mesh = delaunay(points);
  const std::vector<Vec2> corner = circumcentres(points, mesh);
  std::vector<std::vector<Vec2>> cell(points.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int v : mesh.triangles[t]) cell[v].push_back(corner[t]);
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const Vec2 centroid = centroid_around(centres[i], cell[i]);
    if (contains(polygon, centroid)) centres[i] = centroid;
  }
}

std::vector<Vec2> outline_polygon(const Outline& outline, double piece_mm) {
  RandomStream unused(0, "geometry/even");
  return positions(place_on_outline(outline, piece_mm, 0.0, unused));
}

/// A Voronoi corner among real centres lies inside, one that an image takes part in on the outline.
GrainCorner voronoi_corner(const Outline& outline, const std::vector<Vec2>& polygon, Vec2 at, int real_centres) {
  if (real_centres == 3 && contains(polygon, at)) return {at};
  const OutlinePoint on = nearest_on(outline, at);
  return {on.point, on.side, on.along};
}

GrainBorders raw_borders(const Outline& outline, const std::vector<Vec2>& centres, double reach,
                         const std::vector<Vec2>& polygon) {
  const int n = static_cast<int>(centres.size());
  const std::vector<Vec2> points = with_images(outline, centres, reach);
  const Triangulation mesh = delaunay(points);
  const std::vector<Vec2> at = circumcentres(points, mesh);
  GrainBorders borders;
  std::vector<int> corner(mesh.triangles.size(), -1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& triangle = mesh.triangles[t];
    const auto real = std::count_if(triangle.begin(), triangle.end(), [&](int v) { return v < n; });
    if (real < 2) continue;
    corner[t] = static_cast<int>(borders.corners.size());
    borders.corners.push_back(voronoi_corner(outline, polygon, at[t], static_cast<int>(real)));
  }
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) {
      const int beyond = mesh.neighbours[t][k];
      const bool between_grains = mesh.triangles[t][(k + 1) % 3] < n && mesh.triangles[t][(k + 2) % 3] < n;
      if (!between_grains || beyond >= t) continue;
      if (beyond < 0) throw Error(ErrorKind::numerical, "a grain reaches beyond the outline");
      borders.inner.push_back({corner[t], corner[beyond]});
    }
  return borders;
}

}  // namespace

std::vector<Vec2> grain_centres(const Outline& outline, double grain_size_mm, int lloyd_steps, RandomStream& random) {
  const double cell_area = 0.25 * std::numbers::pi * grain_size_mm * grain_size_mm;  // Eq. (G4)
  const int count = std::max(3, static_cast<int>(std::lround(outline.area_mm2 / cell_area)));
  const double reach = 2.5 * std::sqrt(outline.area_mm2 / count);
  const std::vector<Vec2> polygon = outline_polygon(outline, 0.25 * grain_size_mm);
  PointSet set;
  throw_darts(set, polygon, count, 0.6 * grain_size_mm, random);
  std::vector<Vec2> centres = positions(set);
  for (int step = 0; step < lloyd_steps; ++step) lloyd_step(outline, polygon, reach, centres);
  return centres;
}

GrainBorders grain_borders(const Outline& outline, const std::vector<Vec2>& centres, double reach_mm,
                           double shortest_mm) {
  const std::vector<Vec2> polygon = outline_polygon(outline, 0.25 * shortest_mm);
  GrainBorders borders = raw_borders(outline, centres, reach_mm, polygon);
  close_along_outline(borders, outline, shortest_mm);
  collapse_short(borders, shortest_mm);
  return borders;
}

PointSet split_borders(const GrainBorders& borders, const Outline& outline, double edge_mm) {
  BorderSplitter splitter(borders, edge_mm);
  for (std::size_t i = 0; i < borders.loop.size(); ++i)
    splitter.add_arc(borders.loop[i], borders.loop[(i + 1) % borders.loop.size()], outline);
  for (const auto& [a, b] : borders.inner) splitter.add_line(a, b);
  return splitter.take();
}

}  // namespace asperity
