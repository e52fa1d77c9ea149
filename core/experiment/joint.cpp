#include "core/experiment/joint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/base/error.hpp"
#include "core/base/units.hpp"

namespace asperity {
namespace {

bool is_elastic(JointZone zone) { return zone == JointZone::lower_elastic || zone == JointZone::upper_elastic; }
bool is_lower(JointZone zone) { return zone == JointZone::lower_elastic || zone == JointZone::lower_particles; }

void set_bulk(const MaterialConfig& material, PlaneCondition plane, const std::vector<JointZone>& zones,
              Particles& particles) {
  particles.bulk = elastic_constants(material.youngs_modulus_gpa * units::kMpaPerGpa, material.poissons_ratio, plane);
  particles.in_bulk.resize(zones.size());
  std::transform(zones.begin(), zones.end(), particles.in_bulk.begin(),
                 [](JointZone zone) { return static_cast<std::uint8_t>(is_elastic(zone)); });
}

/// y at rest of a strip's lower or upper end, mm: that of the mesh's lowest or highest vertex in it.
double end_level(const JointAssembly& made, int strip, bool upper) {
  const Mesh& mesh = made.joint.mesh;
  double level = upper ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (made.strips.of(t) != strip) continue;
    for (int v : mesh.triangles[t]) {
      level = upper ? std::max(level, mesh.vertices[v].y) : std::min(level, mesh.vertices[v].y);
    }
  }
  return level;
}

/// The ends of all strips on one side as one block: all nodes at rest on their levels.
RigidBlock make_block(const Particles& particles, const std::vector<double>& levels) {
  RigidBlock block;
  for (int node = 0; node < static_cast<int>(particles.node_count()); ++node) {
    const double y = particles.reference(node).y;
    if (std::find(levels.begin(), levels.end(), y) == levels.end()) continue;
    block.nodes.push_back(node);
    block.mass += particles.mass[node];
  }
  return block;
}

/// Lets the upper block turn about the middle of each strip's end; I26 of core/integrator.
void let_turn(const RunConfig& config, const JointStrips& strips, double length, const Particles& particles,
              RigidBlock& block) {
  const double stiffness = config.extensions.rotation_stiffness_n_mm_per_rad;
  if (!std::isfinite(stiffness)) return;
  block.turn.stiffness = strips.count * stiffness;
  const double middle = strips.upper_shift.x + 0.5 * length;
  for (int node : block.nodes) {
    block.turn.arms.push_back({particles.reference(node).x - middle, 0.0});
    block.turn.inertia += particles.mass[node] * dot(block.turn.arms.back(), block.turn.arms.back());
  }
}

/// A gap that leaves at least half of the joint to meet.
void require_gap_within(const RunConfig& config) {
  const double length = joint_profile(config.joint).length(), gap = config.extensions.mismatch_mm;
  if (gap <= 0.5 * length) return;
  throw Error(
      ErrorKind::config,
      {{"/mechanisms", "joint_mismatch shifts the upper half too far", std::to_string(gap) + " mm",
        "gap_mm at most half the joint's length, " + std::to_string(0.5 * length) + " mm", "give a smaller gap_mm"}});
}

}  // namespace

JointAssembly joint_mesh(const RunConfig& config) {
  if (std::vector<Fault> faults = joint_faults(config.joint, config.particles); !faults.empty()) {
    throw Error(ErrorKind::config, std::move(faults));
  }
  require_gap_within(config);
  return make_joint_strips(config.joint, config.particles, config.extensions.strips, config.extensions.mismatch_mm);
}

Joint make_joint(const RunConfig& config, const JointAssembly& made, System& system) {
  const std::vector<JointZone>& zones = made.joint.zone;
  set_bulk(config.material, config.experiment.plane, zones, system.particles);
  std::vector<double> bottoms, tops;
  for (int strip = 0; strip < made.strips.count; ++strip) {
    bottoms.push_back(end_level(made, strip, false));
    tops.push_back(end_level(made, strip, true));
  }
  system.blocks = {make_block(system.particles, bottoms), make_block(system.particles, tops)};
  system.blocks[kUpperBlock].free_along_y = true;
  let_turn(config, made.strips, made.joint.profile.length(), system.particles, system.blocks[kUpperBlock]);
  system.block_of.assign(system.particles.node_count(), -1);
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    for (int node : system.blocks[b].nodes) system.block_of[node] = static_cast<int>(b);
  }
  std::vector<std::uint8_t> lower(zones.size());
  std::transform(zones.begin(), zones.end(), lower.begin(),
                 [](JointZone zone) { return static_cast<std::uint8_t>(is_lower(zone)); });
  Joint joint{joint_profile(config.joint), {}};
  joint.gauge = make_joint_gauge(system.particles, joint.profile, made.strips, std::move(lower));
  return joint;
}

double normal_spring(const RunConfig& config, const Joint& joint) {
  return config.extensions.normal_stiffness_mpa_per_mm * (joint.gauge.strips.count * joint.profile.length());
}

void steady_blocks(const RunConfig& config, const Joint& joint, System& system) {
  const double square = system.time_step * system.time_step;
  RigidBlock &lower = system.blocks[kLowerBlock], &upper = system.blocks[kUpperBlock];
  lower.mass = std::max(lower.mass, square * system.lines[0].stiffness);
  upper.mass = std::max(upper.mass, square * normal_spring(config, joint));
  upper.turn.inertia = std::max(upper.turn.inertia, square * upper.turn.stiffness);
}

}  // namespace asperity
