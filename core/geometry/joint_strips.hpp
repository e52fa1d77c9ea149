#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/geometry/joint_mesh.hpp"

namespace asperity {

/// Where the parts of a joint lie that consists of strips stacked along y, each with its own mesh, and whose upper
/// halves may not lie where they fit; E22 and E24 of core/experiment.
struct JointStrips {
  int count = 1;
  double pitch_mm = 0;     ///< From one strip's plane to the next one's.
  Vec2 upper_shift;        ///< Of the upper halves from where they fit, mm.
  std::vector<int> strip;  ///< Of each triangle; empty: all lie in the first.
  int of(std::size_t triangle) const { return strip.empty() ? 0 : strip[triangle]; }
  double plane(int number) const { return number * pitch_mm; }  ///< y of a strip's plane, mm.
};

/// The strips' meshes as one, with their places.
struct JointAssembly {
  JointMesh joint;
  JointStrips strips;
};

/// Least lift (mm) of an upper half shifted by `gap_mm` along x with which it does not overlap the lower one: the most
/// by which the profile exceeds the shifted profile, found at the corners of both; less than 0 where shifting opens the
/// joint. The gap is below the joint's length.
double mismatch_lift(const JointProfile& profile, double gap_mm);

/// From one strip's seed to the next one's: so far apart that runs of neighbouring seeds share no mesh.
inline constexpr std::uint64_t kStripSeeds = 1'000'000;

/// `count` meshes of the joint, with the seeds particles.seed, particles.seed + kStripSeeds, and so on; upper halves
/// shifted by gap_mm along x and lifted. One strip without a gap is make_joint_mesh() to the byte. The clear distance
/// between strips is twice what the halves can dilate, and four coarse edges. Throws as make_joint_mesh() does.
JointAssembly make_joint_strips(const JointConfig& joint, const ParticleConfig& particles, int count, double gap_mm);

}  // namespace asperity
