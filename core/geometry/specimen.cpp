#include "core/geometry/specimen.hpp"

#include <numbers>

#include "core/geometry/filling.hpp"

namespace asperity {
namespace {

Side half_circle(Vec2 start, Vec2 end, Vec2 centre, double start_angle) {
  return {start, end, centre, norm(start - centre), start_angle, std::numbers::pi};
}

}  // namespace

Outline outline_of(const Rectangle& rectangle) {
  const double x = 0.5 * rectangle.width, h = rectangle.height;
  return {{straight_side({-x, 0.0}, {x, 0.0}), straight_side({x, 0.0}, {x, h}), straight_side({x, h}, {-x, h}),
           straight_side({-x, h}, {-x, 0.0})},
          rectangle.width * h};
}

Outline outline_of(const Disc& disc) {
  const Vec2 bottom{0.0, 0.0}, top{0.0, disc.diameter}, centre{0.0, 0.5 * disc.diameter};
  return {{half_circle(bottom, top, centre, -0.5 * std::numbers::pi),
           half_circle(top, bottom, centre, 0.5 * std::numbers::pi)},
          0.25 * std::numbers::pi * disc.diameter * disc.diameter};
}

Outline outline_of(const ExperimentConfig& experiment) {
  if (experiment.type == ExperimentType::brazilian) return outline_of(Disc{experiment.diameter_mm});
  return outline_of(Rectangle{experiment.width_mm, experiment.height_mm});
}

Mesh make_mesh(const ExperimentConfig& experiment, const ParticleConfig& particles) {
  const Outline outline = outline_of(experiment);
  return particles.kind == ParticleKind::voronoi ? voronoi_mesh(outline, particles) : triangle_mesh(outline, particles);
}

}  // namespace asperity
