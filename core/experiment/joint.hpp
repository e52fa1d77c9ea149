#pragma once
#include <vector>

#include "core/geometry/joint_mesh.hpp"
#include "core/integrator/system.hpp"
#include "core/measurement/joint_gauge.hpp"

/// A joint between its two rigid blocks: the lower one is driven along x and held along y, the upper one is held along
/// x and follows its load along y. Neither rotates.
namespace asperity {

inline constexpr std::size_t kLowerBlock = 0, kUpperBlock = 1;

/// What a direct shear test knows of its joint.
struct Joint {
  JointProfile profile;
  JointGauge gauge;
};

/// The mesh of a joint, and the zone of each of its triangles. Throws a config error with everything that is wrong with
/// the joint.
Mesh joint_mesh(const RunConfig& config, std::vector<JointZone>& zones);

/// Gives the elastic parts the material's elasticity, bonds bottom and top to the blocks, and places the gauges.
Joint make_joint(const RunConfig& config, const Mesh& mesh, const std::vector<JointZone>& zones, System& system);

}  // namespace asperity
