#pragma once
#include <vector>

#include "app/confrontation/confrontation_data.hpp"

namespace asperity::app {

/// Least and largest load over several meshes, over the path that all of them cover.
struct MeshBand {
  std::vector<double> path, lower, upper;
};

/// Of curves whose path may go back in loops: there the first way counts. Empty for fewer than two curves, or without a
/// common path. `points`: 2 or more.
MeshBand mesh_band(const std::vector<ShownCurve>& curves, int points);

}  // namespace asperity::app
