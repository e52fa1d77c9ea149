#include "core/geometry/joint_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "core/base/error.hpp"
#include "core/geometry/filling.hpp"
#include "core/geometry/graded_filling.hpp"
#include "core/geometry/joint_lines.hpp"

namespace asperity {
namespace {

constexpr double kMeanTolerance = 0.03;
constexpr double kMeanCorrected = 0.01;  // A mean further off makes the next attempt change the number of points.
constexpr double kParticleAngleDeg = 25.0;
constexpr double kElasticAngleDeg = 20.0;
constexpr double kDartSpacing = 0.72;  // Over the edge, as in a specimen of triangles.

double relative_deviation(const ParticleConfig& particles) { return particles.edge_deviation() / particles.edge_mm; }

double polygon_area(const std::vector<Vec2>& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) twice += cross(polygon[j], polygon[i]);
  return 0.5 * std::abs(twice);
}

/// Darts in every particle zone, Eq. (G1) with the factor `surplus` on the equilateral count.
void throw_into_zones(JointLines& lines, double edge_mm, double surplus, RandomStream& random) {
  for (const std::vector<int>& zone : lines.zones) {
    std::vector<Vec2> polygon;
    for (int point : zone) polygon.push_back(lines.set.points[point].at);
    const double triangles = surplus * equilateral_count(polygon_area(polygon), edge_mm);
    const double inside = 0.5 * (triangles + 2.0 - static_cast<double>(polygon.size()));
    throw_darts(lines.set, polygon, static_cast<int>(std::lround(std::max(0.0, inside))), kDartSpacing * edge_mm,
                random);
  }
}

void require_angle(const PointSet& set, const Relaxed& relaxed, double least_deg, std::string_view part) {
  std::vector<bool> used(set.points.size(), false);
  for (const auto& triangle : relaxed.mesh.triangles)
    for (int v : triangle) used[v] = true;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (!used[i] && set.points[i].freedom == Freedom::free)
      throw Error(ErrorKind::numerical, fmt::format("a point has left {}", part));
  if (relaxed.regularity.angle_min_deg < least_deg)
    throw Error(ErrorKind::numerical,
                fmt::format("smallest angle {:.3g} degrees in {}", relaxed.regularity.angle_min_deg, part));
}

/// Relaxes the points and drops those that have been squeezed flat between fixed ones: thin zones have many of them.
Relaxed relax_zones(JointLines& lines, double edge_deviation) {
  constexpr int kRounds = 4;
  RelaxationGoal goal;
  goal.edge_deviation = edge_deviation;
  goal.angle_min_deg = kParticleAngleDeg;
  goal.mending_from = 2.0;  // The lines may keep the edges from becoming much more regular than that.
  Relaxed relaxed = relax(lines.set, lines.sides, goal);
  for (int round = 0; round < kRounds && drop_squeezed(lines.set, relaxed.mesh, goal.angle_min_deg); ++round)
    relaxed = relax(lines.set, lines.sides, goal);
  return relaxed;
}

/// The particle zones of both halves together, with the joint as a line inside: its points serve both.
Relaxed fill_particles(JointLines& lines, const ParticleConfig& particles, double& surplus, RandomStream& random) {
  if (lines.zones.empty()) return {};
  mark_sharp_corners(lines.set, kParticleAngleDeg);
  throw_into_zones(lines, particles.edge_mm, surplus, random);
  Relaxed relaxed = relax_zones(lines, relative_deviation(particles));
  const double excess = relaxed.regularity.edge_mean_mm / particles.edge_mm;
  if (std::abs(excess - 1.0) > kMeanCorrected) surplus *= excess * excess;
  if (!(std::abs(excess - 1.0) <= kMeanTolerance))
    throw Error(ErrorKind::numerical, fmt::format("mean edge {:.4g} mm", relaxed.regularity.edge_mean_mm));
  require_angle(lines.set, relaxed, kParticleAngleDeg, "the particles");
  return relaxed;
}

GradedFilling fill_elastic(const JointLines& lines, const std::vector<int>& border, const JointConfig& joint,
                           double outer_y, double edge_mm, RandomStream& random) {
  Grading grading{{}, edge_mm, joint.coarse_edge_mm};
  for (int point : border) grading.fine.push_back(lines.set.points[point].at);
  const double length = grading.fine.back().x;
  GradedFilling filling = fill_graded(grading, {{length, outer_y}, {0.0, outer_y}}, random);
  require_angle(filling.set, filling.filled, kElasticAngleDeg, outer_y < 0.0 ? "the lower half" : "the upper half");
  return filling;
}

/// Pieces of a line of points, each as its two points in ascending order.
std::set<std::array<int, 2>> pieces_of(const std::vector<int>& line) {
  std::set<std::array<int, 2>> pieces;
  for (std::size_t i = 1; i < line.size(); ++i)
    pieces.insert({std::min(line[i - 1], line[i]), std::max(line[i - 1], line[i])});
  return pieces;
}

/// Puts the parts together; each half numbers the points of the particle zones anew, those of the joint too.
class Assembly {
 public:
  Assembly(const JointLines& lines, bool breakable)
      : particles_(lines.set),
        breakable_(breakable),
        border_{pieces_of(lines.lower_border), pieces_of(lines.upper_border)} {
    for (std::vector<int>& v : vertex_) v.assign(particles_.points.size(), -1);
  }

  /// Half 0 is the lower one. The filling's first points are those of `border`.
  void add_elastic(int half, const std::vector<int>& border, const GradedFilling& filling) {
    std::vector<int> own;
    for (std::size_t i = 0; i < filling.set.points.size(); ++i)
      own.push_back(i < border.size() ? vertex(half, border[i]) : add_vertex(filling.set.points[i].at));
    grain_[half] = static_cast<int>(mesh_.triangles.size());
    for (const auto& [a, b, c] : filling.filled.mesh.triangles)
      add_triangle({own[a], own[b], own[c]}, grain_[half], elastic(half));
  }

  /// After both elastic parts.
  void add_particle(const std::array<int, 3>& points, const JointProfile& profile) {
    Vec2 centroid{};
    for (int p : points) centroid += (1.0 / 3.0) * particles_.points[p].at;
    const int half = centroid.y < profile.height_at(centroid.x) ? 0 : 1;
    const bool particle = breakable_ && !on_border(half, points);
    const int grain = particle ? static_cast<int>(mesh_.triangles.size()) : grain_[half];
    const JointZone zone = half == 0 ? JointZone::lower_particles : JointZone::upper_particles;
    add_triangle({vertex(half, points[0]), vertex(half, points[1]), vertex(half, points[2])}, grain,
                 particle ? zone : elastic(half));
  }

  JointMesh take(JointProfile profile, double area_mm2) {
    mesh_.outline_area_mm2 = area_mm2;
    JointMesh joint{sort_along_curve(mesh_), {}, std::move(profile)};
    for (int t : curve_order(mesh_)) joint.zone.push_back(zone_[t]);
    return joint;
  }

 private:
  /// Whether one of a triangle's edges lies on the border between the particle zone and the elastic part.
  bool on_border(int half, const std::array<int, 3>& points) const {
    for (int i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(points[i], points[(i + 1) % 3]);
      if (border_[half].contains({low, high})) return true;
    }
    return false;
  }

  static JointZone elastic(int half) { return half == 0 ? JointZone::lower_elastic : JointZone::upper_elastic; }

  int add_vertex(Vec2 at) {
    mesh_.vertices.push_back(at);
    return static_cast<int>(mesh_.vertices.size()) - 1;
  }

  int vertex(int half, int point) {
    int& number = vertex_[half][point];
    if (number < 0) number = add_vertex(particles_.points[point].at);
    return number;
  }

  void add_triangle(const std::array<int, 3>& corners, int grain, JointZone zone) {
    mesh_.triangles.push_back(corners);
    mesh_.grain.push_back(grain);
    zone_.push_back(zone);
  }

  const PointSet& particles_;
  bool breakable_;
  std::array<std::set<std::array<int, 2>>, 2> border_;  ///< Of each half's particle zone towards its elastic part.
  std::array<std::vector<int>, 2> vertex_;              ///< Of each point of the particle zones, -1: none yet.
  std::array<int, 2> grain_{};
  Mesh mesh_;
  std::vector<JointZone> zone_;
};

JointMesh attempt_joint(const JointConfig& joint, const JointProfile& profile, const ParticleConfig& particles,
                        double& surplus, RandomStream& random) {
  const LineSpacing spacing{particles.edge_mm, relative_deviation(particles)};
  JointLines lines = joint_lines(joint, profile, spacing, random);
  const Relaxed relaxed = fill_particles(lines, particles, surplus, random);
  Assembly assembly(lines, joint.breakable);
  const auto add_elastic = [&](int half, const std::vector<int>& border, double outer_y) {
    assembly.add_elastic(half, border, fill_elastic(lines, border, joint, outer_y, particles.edge_mm, random));
  };
  add_elastic(0, lines.lower_border, -joint.lower_height_mm);
  add_elastic(1, lines.upper_border, joint.upper_height_mm);
  for (const auto& triangle : relaxed.mesh.triangles) assembly.add_particle(triangle, profile);
  return assembly.take(profile, profile.length() * (joint.lower_height_mm + joint.upper_height_mm));
}

}  // namespace

JointMesh make_joint_mesh(const JointConfig& joint, const ParticleConfig& particles) {
  std::vector<Fault> faults = joint_faults(joint, particles);
  if (!faults.empty()) throw Error(ErrorKind::config, std::move(faults));
  const JointProfile profile = joint_profile(joint);
  const double scatter = relative_deviation(particles);
  double surplus = 1.0 + 2.6 * scatter * scatter;  // As in a specimen of triangles.
  JointMesh made;
  made.mesh = first_success(particles, "geometry/joint", [&](RandomStream& random, int) {
    JointMesh attempt = attempt_joint(joint, profile, particles, surplus, random);
    made.zone = std::move(attempt.zone);
    return std::move(attempt.mesh);
  });
  made.profile = profile;
  return made;
}

}  // namespace asperity
