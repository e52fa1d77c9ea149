#include <algorithm>
#include <cmath>
#include <limits>

#include "core/calibration/optimum.hpp"
#include "core/calibration/region.hpp"

namespace asperity {
namespace {

constexpr double kMet = 1e-6;    // of a tolerance: the targets are met again
constexpr double kBeyond = 3.0;  // design extents: a quadratic says nothing there

bool near_design(const std::vector<double>& x, double alpha) {
  return std::all_of(x.begin(), x.end(), [&](double v) { return std::abs(v) <= kBeyond * alpha; });
}

/// More targets than factors cannot all be met: then any least sum of squared misses is a solution.
bool solved(const ResponseSystem& system, const std::vector<double>& x) {
  const std::vector<double> misses = system.misses(x);
  return misses.size() > x.size() ||
         std::all_of(misses.begin(), misses.end(), [](double miss) { return std::abs(miss) < kMet; });
}

/// Percentile of the kept values, with the lost ones half below and half above all of them; infinite if it is among
/// those.
double percentile(const std::vector<double>& sorted, std::size_t lost, double fraction) {
  const double place = fraction * static_cast<double>(sorted.size() + lost - 1) - 0.5 * static_cast<double>(lost);
  if (place < 0.0) return -std::numeric_limits<double>::infinity();
  if (sorted.empty() || place > static_cast<double>(sorted.size() - 1)) return std::numeric_limits<double>::infinity();
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

double sd_of(const std::vector<double>& values) {
  double mean = 0.0, square = 0.0;
  for (double v : values) mean += v / static_cast<double>(values.size());
  for (double v : values) square += (v - mean) * (v - mean);
  return std::sqrt(square / (static_cast<double>(values.size()) - 1.0));
}

}  // namespace

BootstrapRegion bootstrap_region(const ResponseSystem& system, const std::vector<double>& x, double level, double alpha,
                                 const BootstrapOptions& options) {
  BootstrapRegion result;
  result.draws = options.draws;
  std::vector<std::vector<double>> kept(x.size());
  for (std::size_t draw = 0; draw < options.draws; ++draw) {
    const ResponseSystem other = system.redrawn(options.seed, draw);
    const std::vector<double> end = least_misses(other, x);
    if (!near_design(end, alpha) || !solved(other, end)) {
      ++result.lost;
      continue;
    }
    for (std::size_t j = 0; j < x.size(); ++j) kept[j].push_back(end[j]);
  }
  for (std::vector<double>& values : kept) {
    std::sort(values.begin(), values.end());
    result.lower.push_back(percentile(values, result.lost, 0.5 - 0.5 * level));
    result.upper.push_back(percentile(values, result.lost, 0.5 + 0.5 * level));
    result.sd.push_back(sd_of(values));
  }
  return result;
}

}  // namespace asperity
