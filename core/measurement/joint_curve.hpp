#pragma once
#include <optional>
#include <span>

namespace asperity {

/// Least-squares slope of a column over the displacement, over rows between two displacements; Eq. (F20). Empty for
/// fewer than three rows or a displacement that does not change.
std::optional<double> slope_between(std::span<const double> displacement, std::span<const double> values, double from,
                                    double to);

}  // namespace asperity
