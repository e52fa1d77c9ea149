#pragma once
#include <span>
#include <vector>

namespace asperity {

/// Crack length (mm) by direction: sectors of equal width from 0 to 180 degrees, Eq. (M34). A direction is counted from
/// the x axis and has no head, so that 180 is 0.
std::vector<double> rose_lengths(std::span<const double> orientation_deg, std::span<const double> length_mm,
                                 int sectors);

}  // namespace asperity
