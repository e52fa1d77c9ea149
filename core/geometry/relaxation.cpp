#include "core/geometry/relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/units.hpp"

namespace asperity {
namespace {

/// Rest length over mean length. Above 1 the network is under pressure everywhere, so that points spread evenly; from
/// 1.3 on it buckles into crowded and empty places.
constexpr double kPressure = 1.2;
constexpr double kMobility = 0.2;     ///< Move over force; stable up to about 0.3 with six springs a point.
constexpr double kLongestMove = 0.2;  ///< Over the mean edge length: points on a side cannot pass each other.

/// At corner k of a triangle, radians.
double angle_at(const PointSet& set, const std::array<int, 3>& triangle, int k) {
  const Vec2 corner = set.points[triangle[k]].at;
  const Vec2 u = set.points[triangle[(k + 1) % 3]].at - corner, v = set.points[triangle[(k + 2) % 3]].at - corner;
  return std::atan2(std::abs(cross(u, v)), dot(u, v));
}

/// Smallest angle of a triangle, radians; those in sharp corners are not counted.
double smallest_angle(const PointSet& set, const std::array<int, 3>& triangle) {
  double least = std::numbers::pi;
  for (int k = 0; k < 3; ++k)
    if (!set.points[triangle[k]].sharp) least = std::min(least, angle_at(set, triangle, k));
  return least;
}

/// Of the triangle's free points the one at the largest angle; -1: it has none.
int bluntest_free_point(const PointSet& set, const std::array<int, 3>& triangle) {
  int bluntest = -1;
  double largest = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double angle = angle_at(set, triangle, k);
    if (set.points[triangle[k]].freedom != Freedom::free || angle <= largest) continue;
    largest = angle;
    bluntest = triangle[k];
  }
  return bluntest;
}

/// Eq. (G2), mm.
std::vector<Vec2> spring_forces(const std::vector<Vec2>& at, const Triangulation& mesh, double mean_mm) {
  std::vector<Vec2> force(at.size());
  for_each_edge(mesh, [&](int a, int b) {
    const Vec2 d = at[b] - at[a];
    const double length = norm(d);
    const Vec2 push = (std::max(0.0, kPressure * mean_mm - length) / length) * d;
    force[a] -= push;
    force[b] += push;
  });
  return force;
}

/// Eq. (G3).
void move(MeshPoint& point, const Outline& outline, Vec2 force, double mean_mm) {
  const double size = norm(force);
  if (point.freedom == Freedom::fixed || size == 0.0) return;
  const Vec2 step = std::min(kMobility, kLongestMove * mean_mm / size) * force;
  if (point.freedom == Freedom::free) {
    point.at += step;
    return;
  }
  const Side& side = outline.sides[point.side];
  point.along += dot(step, side.tangent(point.along));
  point.at = side.at(point.along);
}

/// Middles of the triangles around each point, Eq. (G7), mm; of a point without any, itself.
std::vector<Vec2> middles(const std::vector<Vec2>& at, const Triangulation& mesh) {
  std::vector<Vec2> moment(at.size());
  std::vector<double> area(at.size(), 0.0);
  for (const auto& triangle : mesh.triangles) {
    const Vec2 a = at[triangle[0]], b = at[triangle[1]], c = at[triangle[2]];
    const double twice = cross(b - a, c - a);
    for (int v : triangle) {
      moment[v] += (twice / 3.0) * (a + b + c);
      area[v] += twice;
    }
  }
  std::vector<Vec2> result(at);
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (area[i] > 0.0) result[i] = (1.0 / area[i]) * moment[i];
  }
  return result;
}

/// 1 for every corner of a triangle with an angle below the one asked for.
std::vector<std::uint8_t> poor_points(const PointSet& set, const Triangulation& mesh, double angle_min_deg) {
  std::vector<std::uint8_t> poor(set.points.size(), 0);
  for (const auto& triangle : mesh.triangles) {
    if (smallest_angle(set, triangle) >= angle_min_deg * units::kRadPerDeg) continue;
    for (int v : triangle) poor[v] = 1;
  }
  return poor;
}

/// Free points among the poor ones go to the middle of their triangles instead of where the springs push them: of some
/// hundred thousand points a few are squeezed flat against the outline, and would leave the specimen.
void mend(PointSet& set, const std::vector<std::uint8_t>& poor, const std::vector<Vec2>& middle) {
  for (std::size_t i = 0; i < poor.size(); ++i) {
    if (poor[i] && set.points[i].freedom == Freedom::free) set.points[i].at = middle[i];
  }
}

bool met(const Regularity& r, const RelaxationGoal& goal) {
  return r.edge_deviation_mm <= goal.edge_deviation * r.edge_mean_mm && r.angle_min_deg >= goal.angle_min_deg;
}

}  // namespace

Regularity measure_regularity(const PointSet& set, const Triangulation& mesh) {
  double sum = 0.0, squares = 0.0, count = 0.0, angle = 4.0;
  for_each_edge(mesh, [&](int a, int b) {
    const double length = norm(set.points[b].at - set.points[a].at);
    sum += length;
    squares += length * length;
    count += 1.0;
  });
  for (const auto& triangle : mesh.triangles) angle = std::min(angle, smallest_angle(set, triangle));
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean)), angle / units::kRadPerDeg};
}

Relaxed relax(PointSet& set, const Outline& outline, const RelaxationGoal& goal) {
  for (int iteration = 0;; ++iteration) {
    const std::vector<Vec2> at = positions(set);
    Triangulation mesh = triangulate(at, set.segments);
    const Regularity regularity = measure_regularity(set, mesh);
    if (met(regularity, goal) || iteration == goal.iterations) return {std::move(mesh), regularity};
    const bool nearly =
        regularity.edge_deviation_mm <= goal.mending_from * goal.edge_deviation * regularity.edge_mean_mm;
    std::vector<std::uint8_t> poor;
    if (nearly && regularity.angle_min_deg < goal.angle_min_deg) poor = poor_points(set, mesh, goal.angle_min_deg);
    const std::vector<Vec2> force = spring_forces(at, mesh, regularity.edge_mean_mm);
    for (std::size_t i = 0; i < at.size(); ++i) move(set.points[i], outline, force[i], regularity.edge_mean_mm);
    if (!poor.empty()) mend(set, poor, middles(at, mesh));
  }
}

bool drop_squeezed(PointSet& set, const Triangulation& mesh, double angle_min_deg) {
  std::vector<bool> kept(set.points.size(), false);
  for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = set.points[i].freedom != Freedom::free;
  for (const auto& triangle : mesh.triangles)
    for (int v : triangle) kept[v] = true;
  for (const auto& triangle : mesh.triangles) {
    const bool whole = kept[triangle[0]] && kept[triangle[1]] && kept[triangle[2]];
    if (!whole || smallest_angle(set, triangle) >= angle_min_deg * units::kRadPerDeg) continue;
    if (const int point = bluntest_free_point(set, triangle); point >= 0) kept[point] = false;
  }
  std::vector<MeshPoint> left;
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (kept[i]) left.push_back(set.points[i]);
  set.points = std::move(left);
  return set.points.size() < kept.size();
}

Relaxed smooth(PointSet& set, int iterations) {
  Relaxed best;
  PointSet best_set;
  for (int iteration = 0; iteration <= iterations; ++iteration) {
    const std::vector<Vec2> at = positions(set);
    Triangulation mesh = triangulate(at, set.segments);
    const Regularity regularity = measure_regularity(set, mesh);
    if (iteration == 0 || regularity.angle_min_deg > best.regularity.angle_min_deg) {
      best = {mesh, regularity};
      best_set = set;
    }
    const std::vector<Vec2> middle = middles(at, mesh);
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (set.points[i].freedom == Freedom::free) set.points[i].at = middle[i];
    }
  }
  set = std::move(best_set);
  return best;
}

}  // namespace asperity
