#pragma once
#include <vector>

#include "core/base/error.hpp"
#include "core/base/vec2.hpp"
#include "core/config/run_config.hpp"

namespace asperity {

/// One tooth of the lower half: a part of the profile above the joint's plane that first rises, then falls.
struct ToothSpan {
  double begin_mm, crest_mm, end_mm;       ///< x of both feet and of the crest (of a flat crest, its middle).
  double height_mm;                        ///< Of the crest above the plane.
  double front_angle_deg, back_angle_deg;  ///< Of the lines from the feet to the crest, against the plane.
};

/// Surface of the lower half: a line of straight pieces over x. The joint's plane is y = 0.
struct JointProfile {
  std::vector<Vec2> points;  ///< Ascending x, the first at x = 0, no three on a line. mm.
  std::vector<ToothSpan> teeth;
  double length() const { return points.back().x; }  ///< Of the plane, mm.
  double height_at(double x) const;                  ///< y of the surface at 0 <= x <= length, mm.
  double lowest() const;                             ///< Least y, mm.
  double highest() const;                            ///< Greatest y, mm.
};

/// The profile from points_mm (moved along x so that it begins at 0) or, where there are none, from the teeth. Teeth
/// are found in either in the same way: see ToothSpan; feet are local minima, or where the profile crosses the plane.
/// Throws Error(config) with all of profile_faults.
JointProfile joint_profile(const JointConfig& joint);

/// What is wrong with the profile in itself.
std::vector<Fault> profile_faults(const JointConfig& joint);

/// All that is wrong with a joint: profile_faults, halves that would overlap, and what triangles of the particles' edge
/// cannot fill.
std::vector<Fault> joint_faults(const JointConfig& joint, const ParticleConfig& particles);

}  // namespace asperity
