#pragma once
#include <array>
#include <vector>

#include "core/geometry/box.hpp"

namespace asperity {

/// All pairs i < j of boxes that touch or overlap, in ascending order. O(n log n) in the number of boxes plus O(k) in
/// that of pairs, whatever the boxes' sizes. Throws Error(numerical) where a bound is no number, as after a blow-up.
std::vector<std::array<int, 2>> near_boxes(const std::vector<Box>& boxes);

}  // namespace asperity
