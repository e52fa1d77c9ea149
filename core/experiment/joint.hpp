#pragma once
#include <vector>

#include "core/geometry/joint_strips.hpp"
#include "core/integrator/system.hpp"
#include "core/measurement/joint_gauge.hpp"

/// A joint between its two rigid blocks: the lower one is driven along x and held along y, the upper one is held along
/// x and follows its load along y. Neither rotates, unless the configuration lets the upper one.
namespace asperity {

inline constexpr std::size_t kLowerBlock = 0, kUpperBlock = 1;

/// What a direct shear test knows of its joint.
struct Joint {
  JointProfile profile;
  JointGauge gauge;
};

/// The mesh of a joint, of all its strips, Eq. (E24), the upper halves shifted by the mismatch, Eq. (E22). Throws a
/// config error with everything that is wrong with the joint.
JointAssembly joint_mesh(const RunConfig& config);

/// Gives the elastic parts the material's elasticity, bonds bottom and top of every strip to the blocks, and places the
/// gauges.
Joint make_joint(const RunConfig& config, const JointAssembly& made, System& system);

/// Stiffness of the spring above the upper block, all strips together, N/mm per mm of thickness; Eq. (E23). 0: none.
double normal_spring(const RunConfig& config, const Joint& joint);

/// Makes blocks that hang on springs so heavy that the time step can follow them.
void steady_blocks(const RunConfig& config, const Joint& joint, System& system);

}  // namespace asperity
