#include <algorithm>

#include "core/measurement/feature_parts.hpp"

namespace asperity {

using namespace feature_limits;
using namespace feature_parts;

namespace {

/// Shares of a loop's range of loads between which its stiffness is read...
constexpr double kLoopLow = 0.2, kLoopHigh = 0.8;
/// ...and, for the line that a reload's toe is measured from, as high as the modulus window is.
constexpr double kReloadLow = 0.5, kReloadHigh = 0.9;
/// Share of the peak at which a reload's toe is read; it begins below.
constexpr double kReloadToe = 0.05;

std::string no_loop(const CurveShape& shape) {
  const std::string why = no_peak(shape);
  if (!why.empty()) return why;
  return shape.reloading.empty() ? "the curve has no unloading with a reload" : "";
}

std::optional<Line> loop_line(const Branch& branch, double low, double high) {
  const auto [least, most] = std::minmax_element(branch.smooth_load.begin(), branch.smooth_load.end());
  const double range = *most - *least;
  return compliance_line(branch, branch.load.size(), *least + low * range, *least + high * range);
}

/// Mean over the loops for which there is a value.
template <class Value>
FeatureValue mean_over(const std::vector<Branch>& branches, const char* none, const Value& value) {
  double sum = 0.0;
  int count = 0;
  for (const Branch& branch : branches) {
    const std::optional<double> one = value(branch);
    if (!one) continue;
    sum += *one;
    ++count;
  }
  if (count == 0) return absent(none);
  return {sum / count, ""};
}

FeatureValue stiffness(const std::vector<Branch>& branches) {
  return mean_over(branches, "fewer than three rows lie in the middle of the loop", [](const Branch& b) {
    const auto line = loop_line(b, kLoopLow, kLoopHigh);
    return line ? std::optional(1.0 / line->slope) : std::nullopt;
  });
}

}  // namespace

FeatureValue loop_count(const CurveShape& shape) { return {static_cast<double>(shape.reloading.size()), ""}; }

FeatureValue unloading_stiffness(const CurveShape& shape) {
  const std::string why = no_loop(shape);
  if (!why.empty()) return {std::nullopt, why};
  return stiffness(shape.unloading);
}

FeatureValue reloading_stiffness(const CurveShape& shape) {
  const std::string why = no_loop(shape);
  if (!why.empty()) return {std::nullopt, why};
  return stiffness(shape.reloading);
}

FeatureValue reload_toe_travel(const CurveShape& shape) {
  const std::string why = no_loop(shape);
  if (!why.empty()) return {std::nullopt, why};
  return mean_over(shape.reloading, "no unloading below 0.05 of the peak",
                   [&](const Branch& b) -> std::optional<double> {
                     const auto line = loop_line(b, kReloadLow, kReloadHigh);
                     return line ? travel_of(b, *line, kReloadToe * shape.peak) : std::nullopt;
                   });
}

FeatureValue permanent_path(const CurveShape& shape) {
  const std::string why = no_loop(shape);
  if (!why.empty()) return {std::nullopt, why};
  return mean_over(shape.reloading, "no unloading below 0.05 of the peak",
                   [&](const Branch& b) -> std::optional<double> {
                     const double load = kReloadToe * shape.peak;
                     if (b.smooth_load.front() >= load) return std::nullopt;
                     const auto before = find_crossing(shape.branch, load, Direction::rising, 0, shape.peak_row + 1);
                     const auto after = find_crossing(b, load, Direction::rising, 0, b.load.size());
                     return before && after ? std::optional(after->path - before->path) : std::nullopt;
                   });
}

}  // namespace asperity
