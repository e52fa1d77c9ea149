#include "core/calibration/residual_checks.hpp"

#include <cmath>
#include <openturns/NormalityTest.hxx>

namespace asperity {
namespace {

constexpr double kRounding = 1e-9;  // residuals this small beside the scatter assumed are rounding: nothing to test

/// Internally studentised: equal variances, as the test of normality assumes.
double normality_p(const LinearFit& fit) {
  OT::Sample scaled(0, 1);
  for (std::size_t i = 0; i < fit.rows.size(); ++i) {
    const double free = 1.0 - fit.leverages[i];
    if (free > kRounding) scaled.add(OT::Point(1, fit.residuals[i] / std::sqrt(free)));
  }
  if (scaled.getSize() < 8) return std::numeric_limits<double>::quiet_NaN();
  return OT::NormalityTest::AndersonDarlingNormal(scaled).getPValue();
}

void find_largest(const LinearFit& fit, ResidualChecks& checks) {
  for (std::size_t i = 0; i < fit.rows.size(); ++i) {
    const double value = fit.studentised[i];
    if (std::isnan(value) || std::abs(value) <= std::abs(checks.largest_studentised)) continue;
    checks.largest_studentised = value;
    checks.row_of_largest = fit.rows[i];
  }
}

double run_order_correlation(const LinearFit& fit) {
  double mean = 0.0;
  for (std::size_t row : fit.rows) mean += static_cast<double>(row) / static_cast<double>(fit.rows.size());
  double product = 0.0, square = 0.0;
  for (std::size_t i = 0; i < fit.rows.size(); ++i) {
    const double place = static_cast<double>(fit.rows[i]) - mean;
    product += place * fit.residuals[i];
    square += place * place;
  }
  return product / std::sqrt(square * fit.residual_sum_of_squares);
}

}  // namespace

ResidualChecks check_residuals(const LinearFit& fit) {
  ResidualChecks checks;
  if (std::sqrt(fit.residual_sum_of_squares / fit.residual_df) < 0.5 * fit.residual_sd) return checks;
  checks.normality_p = normality_p(fit);
  find_largest(fit, checks);
  checks.run_order_correlation = run_order_correlation(fit);
  return checks;
}

}  // namespace asperity
