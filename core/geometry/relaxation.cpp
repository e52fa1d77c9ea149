#include "core/geometry/relaxation.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/units.hpp"

namespace asperity {
namespace {

/// Rest length over mean length. Above 1 the network is under pressure everywhere, so that points spread evenly; from
/// 1.3 on it buckles into crowded and empty places.
constexpr double kPressure = 1.2;
constexpr double kMobility = 0.2;     ///< Move over force; stable up to about 0.3 with six springs a point.
constexpr double kLongestMove = 0.2;  ///< Over the mean edge length: points on a side cannot pass each other.

double smallest_angle(Vec2 a, Vec2 b, Vec2 c) {
  const auto angle = [](Vec2 u, Vec2 v) { return std::atan2(std::abs(cross(u, v)), dot(u, v)); };
  return std::min({angle(b - a, c - a), angle(c - b, a - b), angle(a - c, b - c)});
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
std::vector<std::uint8_t> poor_points(const std::vector<Vec2>& at, const Triangulation& mesh, double angle_min_deg) {
  std::vector<std::uint8_t> poor(at.size(), 0);
  for (const auto& [a, b, c] : mesh.triangles) {
    if (smallest_angle(at[a], at[b], at[c]) < angle_min_deg * units::kRadPerDeg) poor[a] = poor[b] = poor[c] = 1;
  }
  return poor;
}

/// Free points among the poor ones go to the middle of their triangles instead of where the springs push them: of some
/// hundred thousand points a few are squeezed flat against the outline, and would leave the specimen.
void mend(PointSet& set, const std::vector<Vec2>& at, const Triangulation& mesh, double angle_min_deg) {
  const std::vector<std::uint8_t> poor = poor_points(at, mesh, angle_min_deg);
  const std::vector<Vec2> middle = middles(at, mesh);
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (poor[i] && set.points[i].freedom == Freedom::free) set.points[i].at = middle[i];
  }
}

/// Deviation over the one asked for from which on poor triangles are mended one by one.
constexpr double kNearlyRelaxed = 1.15;

bool met(const Regularity& r, const RelaxationGoal& goal) {
  return r.edge_deviation_mm <= goal.edge_deviation * r.edge_mean_mm && r.angle_min_deg >= goal.angle_min_deg;
}

}  // namespace

Regularity measure_regularity(const std::vector<Vec2>& points, const Triangulation& mesh) {
  double sum = 0.0, squares = 0.0, count = 0.0, angle = 4.0;
  for_each_edge(mesh, [&](int a, int b) {
    const double length = norm(points[b] - points[a]);
    sum += length;
    squares += length * length;
    count += 1.0;
  });
  for (const auto& [a, b, c] : mesh.triangles) angle = std::min(angle, smallest_angle(points[a], points[b], points[c]));
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean)), angle / units::kRadPerDeg};
}

Relaxed relax(PointSet& set, const Outline& outline, const RelaxationGoal& goal) {
  for (int iteration = 0;; ++iteration) {
    const std::vector<Vec2> at = positions(set);
    Triangulation mesh = triangulate(at, set.segments);
    const Regularity regularity = measure_regularity(at, mesh);
    if (met(regularity, goal) || iteration == goal.iterations) return {std::move(mesh), regularity};
    const std::vector<Vec2> force = spring_forces(at, mesh, regularity.edge_mean_mm);
    for (std::size_t i = 0; i < at.size(); ++i) move(set.points[i], outline, force[i], regularity.edge_mean_mm);
    const bool nearly = regularity.edge_deviation_mm <= kNearlyRelaxed * goal.edge_deviation * regularity.edge_mean_mm;
    if (nearly && regularity.angle_min_deg < goal.angle_min_deg) mend(set, at, mesh, goal.angle_min_deg);
  }
}

Relaxed smooth(PointSet& set, int iterations) {
  Relaxed best;
  PointSet best_set;
  for (int iteration = 0; iteration <= iterations; ++iteration) {
    const std::vector<Vec2> at = positions(set);
    Triangulation mesh = triangulate(at, set.segments);
    const Regularity regularity = measure_regularity(at, mesh);
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
