#include <algorithm>
#include <cmath>

#include "core/measurement/drops.hpp"
#include "core/measurement/feature_parts.hpp"
#include "core/measurement/results.hpp"

namespace asperity {

using namespace feature_limits;
using namespace feature_parts;

namespace {

/// A first drop is deeper than so many standard deviations of a row's noise.
constexpr double kDropDeviations = 8.0;

/// Mean of the values within some rows of one, from row `begin` on.
double around(const std::vector<double>& values, std::size_t row, std::size_t rows, std::size_t begin) {
  double sum = 0.0;
  std::size_t first = row > begin + rows ? row - rows : begin + 1, last = std::min(values.size() - 1, row + rows);
  if (rows == 0) first = last = row;
  for (std::size_t i = first; i <= last; ++i) sum += values[i];
  return sum / static_cast<double>(last - first + 1);
}

}  // namespace

FeatureValue peak_load(const CurveShape& shape) {
  const std::string why = no_peak(shape);
  if (!why.empty()) return {std::nullopt, why};
  return {shape.peak + base_load(shape.reading), ""};
}

/// Eq. (F28).
FeatureValue largest_load(const CurveShape& shape) {
  if (shape.first.path.size() < kLeastRows || shape.peak <= 0.0)
    return absent("the curve has fewer than ten rows, or bears nothing");
  return {shape.peak + base_load(shape.reading), ""};
}

FeatureValue peak_path(const CurveShape& shape) {
  const std::string why = no_peak(shape);
  if (!why.empty()) return {std::nullopt, why};
  return {shape.peak_path, ""};
}

FeatureValue peak_path_from_toe(const CurveShape& shape) {
  const std::string why = no_line(shape);
  if (!why.empty()) return {std::nullopt, why};
  return {loading_path(shape), ""};
}

FeatureValue splitting_strength(const CurveShape& shape) {
  const FeatureValue load = peak_load(shape);
  if (!load.value) return load;
  if (!shape.reading.diameter_mm) return absent("the disc's diameter is not known");
  return {splitting_stress(*load.value, *shape.reading.diameter_mm), ""};
}

FeatureValue first_drop_stress(const CurveShape& shape) {
  const std::string why = no_peak(shape);
  if (!why.empty()) return {std::nullopt, why};
  if (!shape.reading.diameter_mm) return absent("the disc's diameter is not known");
  const std::size_t reach = rows_in_reach(shape.first.path, shape.reading.path_limit);
  const std::span<const double> loads(shape.branch.smooth_load.data(), reach);
  const FirstDropRule rule{0.5 * shape.peak, kDropDeviations * shape.reading.load_noise * shape.peak};
  const auto load = first_drop(loads, shape.first.events, rule);
  if (!load) return absent("the load never falls by a tenth");
  return {splitting_stress(*load, *shape.reading.diameter_mm), ""};
}

FeatureValue drop_share(const CurveShape& shape) {
  const std::string why = no_line(shape);
  if (!why.empty()) return {std::nullopt, why};
  const std::size_t rows = shape.branch.load.size();
  const auto fall = find_crossing(shape.branch, kFallBegins * shape.peak, Direction::falling, shape.peak_row, rows);
  if (!fall) return absent("the load does not fall to 0.95 of the peak");
  const auto left = load_at(shape.branch, fall->path + kDropSpan * loading_path(shape), fall->row);
  if (!left) return absent("the curve ends before the stated path behind the peak");
  return {kFallBegins - *left / shape.peak, ""};
}

FeatureValue softening_path(const CurveShape& shape) {
  const std::string why = no_peak(shape);
  if (!why.empty()) return {std::nullopt, why};
  const std::size_t rows = shape.branch.load.size();
  const auto high = find_crossing(shape.branch, kSofteningHigh * shape.peak, Direction::falling, shape.peak_row, rows);
  const auto low = find_crossing(shape.branch, kSofteningLow * shape.peak, Direction::falling, shape.peak_row, rows);
  if (!high || !low) return absent("the load does not fall to half the peak");
  return {low->path - high->path, ""};
}

FeatureValue residual_load(const CurveShape& shape) {
  const std::string why = no_peak(shape);
  if (!why.empty()) return {std::nullopt, why};
  const std::vector<double>& path = shape.first.path;
  const std::vector<std::size_t> rows = late_rows(path, kLateShare);
  if (rows.size() < 3) return absent("fewer than three rows lie in the last quarter of the path");
  if (path[rows.front()] <= shape.peak_path)
    return absent("the curve ends less than a third of the peak's path behind it");
  const Line line = fit_line(gather(path, rows), gather(shape.first.load, rows));
  if (std::abs(line.slope) * kLateShare * path.back() > kSteady * shape.peak) {
    return absent("the load still changes by a fifth of the peak over the last quarter of the path");
  }
  return {mean_at(shape.first.load, rows), ""};
}

FeatureValue drop_count(const CurveShape& shape) {
  const std::string why = no_peak(shape);
  if (!why.empty()) return {std::nullopt, why};
  return {static_cast<double>(find_drops(shape.branch.smooth_load, kDropShare * shape.peak).size()), ""};
}

FeatureValue largest_drop(const CurveShape& shape) {
  const std::string why = no_peak(shape);
  if (!why.empty()) return {std::nullopt, why};
  const std::vector<double>& load = shape.branch.smooth_load;
  double largest = 0.0;
  for (const Drop& drop : find_drops(load, kDropShare * shape.peak)) {
    largest = std::max(largest, load[drop.high] - around(load, drop.low, shape.smoothing_rows, drop.high));
  }
  if (largest == 0.0) return absent("the load never falls by a tenth of the peak");
  return {largest, ""};
}

FeatureValue rise_after_drop(const CurveShape& shape) {
  const std::string why = no_peak(shape);
  if (!why.empty()) return {std::nullopt, why};
  const std::vector<double>& load = shape.branch.smooth_load;
  const std::vector<Drop> drops = find_drops(load, kDropShare * shape.peak);
  if (drops.empty()) return absent("the load never falls by a tenth of the peak");
  const std::size_t low = drops.front().low;
  return {*std::max_element(load.begin() + low, load.end()) - load[low], ""};
}

}  // namespace asperity
