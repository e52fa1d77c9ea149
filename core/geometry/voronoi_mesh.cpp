#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/error.hpp"
#include "core/geometry/filling.hpp"
#include "core/geometry/grains.hpp"

namespace asperity {
namespace {

constexpr double kAngleMinDeg = 10.0;
constexpr double kShortestBorder = 0.4;  // Over edge_mm, or over the mean side of a grain if that is shorter.
constexpr double kHexagonSide = 0.55;    // Of a regular hexagon over the diameter of the circle of the same area.
constexpr int kCandidates = 24;
constexpr int kSmoothings = 20;

/// A grain before its inner points are placed: the triangles between its corners.
struct GrainPatch {
  std::vector<int> triangles;
  std::vector<Vec2> points;  ///< On its border (with repetitions), then inside.
  double area_mm2 = 0.0;
};

double triangle_area(const std::vector<Vec2>& at, const std::array<int, 3>& t) {
  return 0.5 * cross(at[t[1]] - at[t[0]], at[t[2]] - at[t[0]]);
}

std::vector<GrainPatch> grain_patches(const std::vector<Vec2>& at, const Triangulation& mesh) {
  std::vector<GrainPatch> patches;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const std::size_t region = mesh.region[t];
    if (region >= patches.size()) patches.resize(region + 1);
    patches[region].triangles.push_back(t);
    patches[region].area_mm2 += triangle_area(at, mesh.triangles[t]);
    for (int v : mesh.triangles[t]) patches[region].points.push_back(at[v]);
  }
  return patches;
}

Vec2 random_point(const GrainPatch& patch, const std::vector<Vec2>& at, const Triangulation& mesh,
                  RandomStream& random) {
  double area = random.uniform() * patch.area_mm2;
  int chosen = patch.triangles.back();
  for (int t : patch.triangles) {
    area -= triangle_area(at, mesh.triangles[t]);
    if (area >= 0.0) continue;
    chosen = t;
    break;
  }
  double u = random.uniform(), v = random.uniform();
  if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
  const auto& [a, b, c] = mesh.triangles[chosen];
  return at[a] + u * (at[b] - at[a]) + v * (at[c] - at[a]);
}

double clearance(const std::vector<Vec2>& points, Vec2 p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2& q : points) least = std::min(least, norm(p - q));
  return least;
}

/// Eq. (G6): points inside, so that the grain's triangles have about the asked edge and number at least two.
int inner_points(const GrainPatch& patch, double edge_mm) {
  const int empty = static_cast<int>(patch.triangles.size());
  const double wanted = equilateral_count(patch.area_mm2, edge_mm);
  return std::max(empty < 2 ? 1 : 0, static_cast<int>(std::lround(0.5 * (wanted - empty))));
}

/// Each point is the one farthest from all others among a few candidates (Mitchell's best candidate).
void place_inside_grains(PointSet& set, double edge_mm, RandomStream& random) {
  const std::vector<Vec2> at = positions(set);
  const Triangulation mesh = triangulate(at, set.segments);
  for (GrainPatch& patch : grain_patches(at, mesh)) {
    for (int placed = 0, wanted = inner_points(patch, edge_mm); placed < wanted; ++placed) {
      Vec2 best = random_point(patch, at, mesh, random);
      for (int i = 1; i < kCandidates; ++i) {
        const Vec2 p = random_point(patch, at, mesh, random);
        if (clearance(patch.points, p) > clearance(patch.points, best)) best = p;
      }
      patch.points.push_back(best);
      set.points.push_back({best});
    }
  }
}

Mesh attempt_voronoi(const Outline& outline, const ParticleConfig& particles, int lloyd_steps, RandomStream& random) {
  const double grain = particles.grain_size_mm;
  const double shortest = kShortestBorder * std::min(particles.edge_mm, kHexagonSide * grain);
  const std::vector<Vec2> centres = grain_centres(outline, grain, lloyd_steps, random);
  const GrainBorders borders = grain_borders(outline, centres, 2.5 * grain, shortest);
  PointSet set = split_borders(borders, outline, particles.edge_mm);
  place_inside_grains(set, particles.edge_mm, random);
  const Relaxed relaxed = smooth(set, kSmoothings);
  const double angle = relaxed.regularity.angle_min_deg;
  if (angle < kAngleMinDeg) throw Error(ErrorKind::numerical, fmt::format("smallest angle {:.3g} degrees", angle));
  return to_mesh(set, relaxed.mesh, relaxed.mesh.region, outline.area_mm2);
}

}  // namespace

Mesh voronoi_mesh(const Outline& outline, const ParticleConfig& particles) {
  constexpr int kLloydSteps = 4;  // Each further attempt takes one more: a more regular, easier arrangement.
  return first_success(particles, "geometry/voronoi", [&](RandomStream& random, int k) {
    return attempt_voronoi(outline, particles, kLloydSteps + k, random);
  });
}

}  // namespace asperity
