#pragma once
#include <cstddef>
#include <limits>

#include "core/calibration/linear_fit.hpp"

namespace asperity {

/// What the residuals say about the assumptions behind every p value. NaN where it cannot be told.
struct ResidualChecks {
  /// Anderson-Darling test of normal residuals, mean and variance unknown. This test because it weighs the tails, where
  /// a run that went another way shows, and because OpenTURNS has its p value for estimated parameters (its
  /// Kolmogorov-Smirnov and chi-squared tests assume known ones or many runs). Residuals of a fit are a little
  /// correlated, so the p value is a guide.
  double normality_p = std::numeric_limits<double>::quiet_NaN();
  double largest_studentised = std::numeric_limits<double>::quiet_NaN();    ///< With its sign.
  std::size_t row_of_largest = 0;                                           ///< Row of the design.
  double run_order_correlation = std::numeric_limits<double>::quiet_NaN();  ///< Of the residuals with the run's place.
};

/// Checks of a fit's residuals, Eq. (S13).
ResidualChecks check_residuals(const LinearFit& fit);

}  // namespace asperity
