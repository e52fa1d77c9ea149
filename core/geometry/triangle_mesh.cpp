#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "core/base/error.hpp"
#include "core/geometry/filling.hpp"

namespace asperity {
namespace {

constexpr double kMeanTolerance = 0.02;
constexpr double kMeanCorrected = 0.01;       // A mean further off makes the next attempt change the number of points.
constexpr double kDeviationTolerance = 1.25;  // Over the deviation asked for.
constexpr double kAngleMinDeg = 25.0;
constexpr double kDartSpacing = 0.72;  // Over the edge: 93 % of the spacing at which darts saturate at this density.
constexpr double kMostOutlineScatter = 0.2;

/// Eq. (G1): points inside for a given number of triangles and points on the outline.
int inner_points(double triangles, int outline_points) {
  return std::max(1, static_cast<int>(std::lround(0.5 * (triangles + 2.0 - outline_points))));
}

void require(const Regularity& r, const ParticleConfig& particles) {
  const bool good = std::abs(r.edge_mean_mm / particles.edge_mm - 1.0) <= kMeanTolerance &&
                    r.edge_deviation_mm <= kDeviationTolerance * particles.edge_deviation() &&
                    r.angle_min_deg >= kAngleMinDeg;
  if (good) return;
  throw Error(ErrorKind::numerical,
              fmt::format("mean edge {:.4g} mm, standard deviation {:.3g} mm, smallest angle {:.3g} degrees",
                          r.edge_mean_mm, r.edge_deviation_mm, r.angle_min_deg));
}

Relaxed fill(PointSet& set, const Outline& outline, const ParticleConfig& particles, double triangles,
             RandomStream& random) {
  const int points = inner_points(triangles, static_cast<int>(set.points.size()));
  throw_darts(set, positions(set), points, kDartSpacing * particles.edge_mm, random);
  RelaxationGoal goal;
  goal.edge_deviation = particles.edge_deviation() / particles.edge_mm;
  goal.angle_min_deg = kAngleMinDeg;
  return relax(set, outline, goal);
}

}  // namespace

Mesh triangle_mesh(const Outline& outline, const ParticleConfig& particles) {
  const double scatter = particles.edge_deviation() / particles.edge_mm;
  // Scattered edges are longer on average than equilateral ones of the same number; the excess, about 2.6 scatter^2
  // (fitted), is corrected from each attempt for the next.
  double triangles = equilateral_count(outline.area_mm2, particles.edge_mm) * (1.0 + 2.6 * scatter * scatter);
  return first_success(particles, "geometry/triangles", [&](RandomStream& random, int) {
    PointSet set = place_on_outline(outline, particles.edge_mm, std::min(scatter, kMostOutlineScatter), random);
    const Relaxed relaxed = fill(set, outline, particles, triangles, random);
    const double excess = relaxed.regularity.edge_mean_mm / particles.edge_mm;
    if (std::abs(excess - 1.0) > kMeanCorrected) triangles *= excess * excess;
    require(relaxed.regularity, particles);
    std::vector<int> own(relaxed.mesh.triangles.size());
    std::iota(own.begin(), own.end(), 0);
    return to_mesh(set, relaxed.mesh, std::move(own), outline.area_mm2);
  });
}

}  // namespace asperity
