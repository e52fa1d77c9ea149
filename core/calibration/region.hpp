#pragma once
#include <cstdint>
#include <vector>

#include "core/calibration/response_system.hpp"

/// How well the runs tell the parameters of a solution.
namespace asperity {

/// Confidence region of a solution, coded, by the delta method.
struct ConfidenceRegion {
  double level = 0.95;
  int df = 0;  ///< Degrees of freedom of the scatter behind it.
  /// Of the parameters, k by k, Eq. (S23); along a direction never more than what the design's diameter allows.
  std::vector<double> covariance;
  /// Of one parameter by itself: holds it with probability `level`, Eq. (S25).
  std::vector<double> interval_lower, interval_upper;
  /// Of all parameters at once: the box holds them together with probability `level` or more, Eq. (S26).
  std::vector<double> lower, upper;
  /// False where the parameter's own interval leaves the design, [-alpha, alpha]: the runs do not bound it.
  std::vector<bool> determined;
  /// How many of its standard errors the responses change by for one coded unit along each direction, largest first; 0
  /// where nothing changes.
  std::vector<double> singular_values;
  std::vector<std::vector<double>> directions;  ///< Unit vectors, one a singular value.
  std::vector<bool> direction_determined;       ///< The interval along the direction is within +-alpha.
};

/// The region about a solution x of the system, Eqs. (S23)-(S26); alpha: the design's reach.
ConfidenceRegion confidence_region(const ResponseSystem& system, const std::vector<double>& x, double level,
                                   double alpha);

/// Whether the targets could be the responses of parameters x, Eq. (S27): the exact joint region of Box & Hunter (1954)
/// for normal scatter and true models, however curved, with no solution needed.
bool in_joint_region(const ResponseSystem& system, const std::vector<double>& x, double level);

/// What the solution would have been with other mesh scatter.
struct BootstrapRegion {
  std::size_t draws = 0;
  std::size_t lost = 0;  ///< Draws whose solution vanished or left 3 alpha.
  std::vector<double> lower,
      upper;               ///< Percentiles of each parameter at the level, coded; lost draws count as beyond both.
  std::vector<double> sd;  ///< Over the draws that are not lost.
};

struct BootstrapOptions {
  std::size_t draws = 500;
  std::uint64_t seed = 1;
};

/// Parametric bootstrap: refits to simulated responses and solves again from x.
BootstrapRegion bootstrap_region(const ResponseSystem& system, const std::vector<double>& x, double level, double alpha,
                                 const BootstrapOptions& options);

}  // namespace asperity
