#pragma once
#include <vector>

#include "core/calibration/optimum.hpp"

namespace asperity {

/// Climbs the merit of Eq. (S22) from `start` without leaving the region (COBYLA: the desirability has kinks where a
/// target is met, so no derivative is used). Returns the best point, never a worse one than `start`.
std::vector<double> climb(const ResponseSystem& system, const SearchRegion& region, const std::vector<double>& start,
                          const DesirabilityOptions& options);

}  // namespace asperity
