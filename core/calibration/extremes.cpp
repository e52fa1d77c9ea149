#include <cmath>
#include <openturns/SobolSequence.hxx>

#include "core/calibration/paper_audit.hpp"

namespace asperity {
namespace {

constexpr std::size_t kStarts = 64;  // a quadratic has few local extremes on a sphere (at most two a factor)
constexpr int kSteps = 2000;
constexpr double kStill = 1e-12;

std::vector<double> gradient(const LinearFit& fit, const std::vector<double>& x) {
  std::vector<double> sum(x.size(), 0.0);
  for (std::size_t j = 0; j < x.size(); ++j) {
    for (std::size_t i = 0; i < fit.terms.size(); ++i) {
      sum[j] += fit.coefficients[i] * term_derivative(fit.terms[i], x, static_cast<int>(j));
    }
  }
  return sum;
}

/// Bound of the quadratic's curvature in any direction.
double curvature_bound(const LinearFit& fit) {
  double sum = 0.0;
  for (std::size_t i = 0; i < fit.terms.size(); ++i) {
    if (fit.terms[i].second >= 0) sum += 2.0 * std::abs(fit.coefficients[i]);
  }
  return sum;
}

/// Projected gradient ascent of sign * fit; a step of the inverse curvature cannot overshoot.
double climb_to(const LinearFit& fit, std::vector<double> x, const SearchRegion& region, double sign) {
  const double bound = curvature_bound(fit);
  const double step = bound > 0.0 ? 1.0 / bound : 1e6;
  for (int i = 0; i < kSteps; ++i) {
    const std::vector<double> slope = gradient(fit, x);
    std::vector<double> next = x;
    for (std::size_t j = 0; j < x.size(); ++j) next[j] += sign * step * slope[j];
    next = drawn_in(region, std::move(next));
    double moved = 0.0;
    for (std::size_t j = 0; j < x.size(); ++j) moved += std::abs(next[j] - x[j]);
    x = std::move(next);
    if (moved < kStill) break;
  }
  return evaluate(fit, x);
}

}  // namespace

std::pair<double, double> extremes(const LinearFit& fit, double alpha) {
  const SearchRegion region{RegionShape::sphere, alpha};
  std::size_t factors = 0;
  for (const Term& term : fit.terms) factors += kind_of(term) == TermKind::linear;
  const OT::Sample sobol = OT::SobolSequence(factors).generate(kStarts);
  double low = INFINITY, high = -INFINITY;
  for (std::size_t i = 0; i < kStarts; ++i) {
    std::vector<double> x(factors);
    for (std::size_t j = 0; j < factors; ++j) x[j] = alpha * (2.0 * sobol(i, j) - 1.0);
    x = drawn_in(region, std::move(x));
    low = std::min(low, climb_to(fit, x, region, -1.0));
    high = std::max(high, climb_to(fit, x, region, 1.0));
  }
  return {low, high};
}

}  // namespace asperity
