#pragma once
#include <vector>

#include "core/base/random.hpp"
#include "core/config/run_config.hpp"
#include "core/geometry/joint_profile.hpp"
#include "core/geometry/outline.hpp"
#include "core/geometry/points.hpp"

namespace asperity {

/// The lines that bound a joint's particle zones, with points about one particle edge apart, before any point is placed
/// inside. Lines are lists of point numbers from x = 0 to x = length.
struct JointLines {
  PointSet set;
  Outline sides;  ///< Straight pieces that the sliding points lie on; no closed chain.
  std::vector<int> joint;
  std::vector<int> lower_border;  ///< Between the lower half's elastic part and the particles, or the joint itself.
  std::vector<int> upper_border;  ///< The same in the upper half.
  std::vector<std::vector<int>>
      zones;  ///< Closed border of each particle zone. Any number of them: a tooth may be one.
};

/// Distances between the points of a line.
struct LineSpacing {
  double edge_mm;  ///< Mean.
  double scatter;  ///< Relative standard deviation.
};

/// The lower particles reach down to a level damage_depth_lower_mm below the profile's lowest point, the upper ones up
/// to the roof, Eq. (G11); neither nearer than coarse_edge_mm to the half's outer edge. A depth of 0 leaves, in the
/// lower half, the teeth above the lowest point; in the upper half nothing.
JointLines joint_lines(const JointConfig& joint, const JointProfile& profile, const LineSpacing& spacing,
                       RandomStream& random);

/// Eq. (G11): height above x of everything nearer than depth_mm to the profile, mm.
double roof_height(const JointProfile& profile, double depth_mm, double x);

}  // namespace asperity
