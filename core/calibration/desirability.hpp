#pragma once
#include <vector>

#include "core/calibration/response_system.hpp"

/// Target-is-best desirability (Derringer & Suich 1980).
namespace asperity {

struct DesirabilityOptions {
  double half_range = 0.25;  ///< Relative miss at which the desirability has fallen to 0.
  double exponent = 1.0;     ///< 1: it falls linearly.
};

/// One response's desirability, Eq. (S20): 1 on the target, 0 from the half range on.
double desirability(double value, const Target& target, const DesirabilityOptions& options);

/// Weighted geometric mean over the targets, Eq. (S21); `values` in the order of the targets.
double overall_desirability(const std::vector<double>& values, const std::vector<Target>& targets,
                            const DesirabilityOptions& options);

/// What an ascent climbs, Eq. (S22): the overall desirability where it is above 0; elsewhere, where that is flat, minus
/// the weighted squared misses over their half ranges (at most minus the smallest weight there, so always below it).
double merit(const ResponseSystem& system, const std::vector<double>& x, const DesirabilityOptions& options);

/// Gradient of what Eq. (S22) climbs by the coded factors; of the logarithm of the desirability where that is above 0.
std::vector<double> merit_gradient(const ResponseSystem& system, const std::vector<double>& x,
                                   const DesirabilityOptions& options);

}  // namespace asperity
