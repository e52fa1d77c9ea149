#include <algorithm>

#include "core/measurement/feature_parts.hpp"
#include "core/measurement/joint_curve.hpp"

namespace asperity {

using namespace feature_limits;
using namespace feature_parts;

namespace {

std::string no_dilation(const CurveShape& shape) {
  const std::string why = no_peak(shape);
  if (!why.empty()) return why;
  return shape.first.dilation_mm.empty() ? "dilation_mm was not recorded" : "";
}

double at_peak(const CurveShape& shape, const std::vector<double>& column) {
  return trailing_values(column, shape.smoothing_rows)[shape.peak_row];
}

/// Front less rear rise, Eq. (F21); empty where fewer than two gauges were read.
std::vector<double> difference(const CurveShape& shape) {
  const Curve& c = shape.first;
  std::vector<double> gap;
  for (std::size_t i = 0; i < c.dilation_rear_mm.size(); ++i) {
    if (!c.dilation_front_mm.empty()) {
      gap.push_back(c.dilation_front_mm[i] - c.dilation_rear_mm[i]);
    } else if (!c.dilation_mm.empty()) {
      gap.push_back(2.0 * (c.dilation_mm[i] - c.dilation_rear_mm[i]));
    }
  }
  return gap;
}

/// Slope of a column over the displacement between two displacements.
FeatureValue rate(const CurveShape& shape, const std::vector<double>& column, double from, double to) {
  const auto slope = slope_between(shape.first.path, column, from, to);
  if (!slope) return absent("fewer than three rows lie there");
  return {*slope, ""};
}

}  // namespace

FeatureValue peak_dilation(const CurveShape& shape) {
  const std::string why = no_dilation(shape);
  if (!why.empty()) return {std::nullopt, why};
  return {at_peak(shape, shape.first.dilation_mm), ""};
}

FeatureValue end_dilation(const CurveShape& shape) {
  if (shape.first.dilation_mm.empty()) return absent("dilation_mm was not recorded");
  return {trailing_values(shape.first.dilation_mm, shape.smoothing_rows).back(), ""};
}

FeatureValue dilation_rate_before_peak(const CurveShape& shape) {
  const std::string why = no_dilation(shape);
  if (!why.empty()) return {std::nullopt, why};
  return rate(shape, shape.first.dilation_mm, kRateShare * shape.peak_path, shape.peak_path);
}

FeatureValue dilation_rate_after_peak(const CurveShape& shape) {
  const std::string why = no_dilation(shape);
  if (!why.empty()) return {std::nullopt, why};
  if (shape.first.path.back() < 2.0 * shape.peak_path)
    return absent("the curve ends before twice the peak's displacement");
  return rate(shape, shape.first.dilation_mm, shape.peak_path, 2.0 * shape.peak_path);
}

FeatureValue dilation_difference_at_peak(const CurveShape& shape) {
  const std::string why = no_peak(shape);
  if (!why.empty()) return {std::nullopt, why};
  const std::vector<double> gap = difference(shape);
  if (gap.empty()) return absent("dilation was not recorded at two ends");
  return {at_peak(shape, gap), ""};
}

FeatureValue dilation_difference_rate(const CurveShape& shape) {
  const std::string why = no_peak(shape);
  if (!why.empty()) return {std::nullopt, why};
  const std::vector<double> gap = difference(shape);
  if (gap.empty()) return absent("dilation was not recorded at two ends");
  return rate(shape, gap, kRateShare * shape.peak_path, shape.peak_path);
}

}  // namespace asperity
