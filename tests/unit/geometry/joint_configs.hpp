#pragma once
#include "core/config/run_config.hpp"

namespace asperity::test {

/// The paper's joints: teeth 5 mm high between flats of 3.5 mm, 24.32 mm and 61.64 mm long.
inline JointConfig single_tooth() { return {}; }

inline JointConfig double_tooth() {
  JointConfig joint;
  joint.profile = {{15.0, 5.0, 3.5}, {30.0, 5.0, 0.0}};
  return joint;
}

inline JointConfig rough_joint() {
  JointConfig joint;
  joint.profile.clear();
  joint.points_mm = {{0, 0},    {2, 0.6},  {4.5, 1.8}, {6, 1.1}, {8, 2.6},   {9.5, -0.4},
                     {12, 0.2}, {14, 1.9}, {17, 0.3},  {19, 1},  {22, -0.6}, {25, 0}};
  return joint;
}

/// Particles in the teeth alone, as in the paper's Fig. 7.
inline JointConfig teeth_alone(JointConfig joint) {
  joint.damage_depth_lower_mm = joint.damage_depth_upper_mm = 0.0;
  return joint;
}

}  // namespace asperity::test
