#include "core/experiment/joint.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "core/base/units.hpp"

namespace asperity {
namespace {

bool is_elastic(JointZone zone) { return zone == JointZone::lower_elastic || zone == JointZone::upper_elastic; }
bool is_lower(JointZone zone) { return zone == JointZone::lower_elastic || zone == JointZone::lower_particles; }

void set_bulk(const MaterialConfig& material, PlaneCondition plane, const std::vector<JointZone>& zones,
              Particles& particles) {
  particles.bulk =
      elastic_constants(material.youngs_modulus_gpa * units::kMpaPerGpa, material.poissons_ratio, plane);
  particles.in_bulk.resize(zones.size());
  std::transform(zones.begin(), zones.end(), particles.in_bulk.begin(),
                 [](JointZone zone) { return static_cast<std::uint8_t>(is_elastic(zone)); });
}

/// All nodes at rest on the level y, mm.
RigidBlock make_block(const Particles& particles, double y) {
  RigidBlock block;
  for (int node = 0; node < static_cast<int>(particles.node_count()); ++node) {
    if (particles.reference(node).y != y) continue;
    block.nodes.push_back(node);
    block.mass += particles.mass[node];
  }
  return block;
}

}  // namespace

Mesh joint_mesh(const RunConfig& config, std::vector<JointZone>& zones) {
  if (std::vector<Fault> faults = joint_faults(config.joint, config.particles); !faults.empty()) {
    throw Error(ErrorKind::config, std::move(faults));
  }
  JointMesh made = make_joint_mesh(config.joint, config.particles);
  zones = std::move(made.zone);
  return std::move(made.mesh);
}

Joint make_joint(const RunConfig& config, const Mesh& mesh, const std::vector<JointZone>& zones, System& system) {
  set_bulk(config.material, config.experiment.plane, zones, system.particles);
  const auto by_height = [](Vec2 a, Vec2 b) { return a.y < b.y; };
  const auto [lowest, highest] = std::minmax_element(mesh.vertices.begin(), mesh.vertices.end(), by_height);
  system.blocks = {make_block(system.particles, lowest->y), make_block(system.particles, highest->y)};
  system.blocks[kUpperBlock].free_along_y = true;
  system.block_of.assign(system.particles.node_count(), -1);
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    for (int node : system.blocks[b].nodes) system.block_of[node] = static_cast<int>(b);
  }
  std::vector<std::uint8_t> lower(zones.size());
  std::transform(zones.begin(), zones.end(), lower.begin(),
                 [](JointZone zone) { return static_cast<std::uint8_t>(is_lower(zone)); });
  Joint joint{joint_profile(config.joint), {}};
  joint.gauge = make_joint_gauge(system.particles, joint.profile, std::move(lower));
  return joint;
}

}  // namespace asperity
