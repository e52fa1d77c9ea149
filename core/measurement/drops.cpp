#include "core/measurement/drops.hpp"

#include <algorithm>

namespace asperity {

std::vector<Drop> find_drops(std::span<const double> load, double least) {
  std::vector<Drop> drops;
  std::size_t high = 0, low = 0;
  const auto enter = [&] {
    if (low > high && load[high] - load[low] >= least) drops.push_back({high, low});
  };
  for (std::size_t i = 0; i < load.size(); ++i) {
    if (load[i] < load[low]) low = i;
    const bool risen = load[i] > load[low] + least;
    if (load[i] <= load[high] && !(risen && low > high)) continue;
    enter();
    high = low = i;
  }
  if (!load.empty()) enter();
  return drops;
}

std::optional<double> first_drop(std::span<const double> load, std::span<const double> events,
                                 const FirstDropRule& rule) {
  constexpr double kDrop = 0.1;
  double largest = 0.0;
  for (std::size_t i = 0; i < load.size(); ++i) {
    largest = std::max(largest, load[i]);
    const bool counts = events.empty() ? largest >= rule.bearing : events[i] > 0.0;
    if (counts && load[i] < (1.0 - kDrop) * largest && largest - load[i] > rule.noise) return largest;
  }
  return std::nullopt;
}

std::vector<std::size_t> late_rows(std::span<const double> path, double share) {
  std::vector<std::size_t> rows;
  const double from = path.empty() ? 0.0 : (1.0 - share) * path.back();
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (path[i] >= from) rows.push_back(i);
  }
  return rows;
}

double mean_at(std::span<const double> values, std::span<const std::size_t> rows) {
  double sum = 0.0;
  for (const std::size_t row : rows) sum += values[row];
  return sum / static_cast<double>(rows.size());
}

}  // namespace asperity
