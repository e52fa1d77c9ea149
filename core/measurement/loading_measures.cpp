#include <algorithm>

#include "core/measurement/feature_parts.hpp"
#include "core/measurement/results.hpp"

namespace asperity {

using namespace feature_limits;
using namespace feature_parts;

namespace {

/// Load at which the line, bent by the share of stiffness that may be lost, meets the curve; Eq. (F11).
FeatureValue load_where_bent(const CurveShape& shape, const Branch& branch, const Line& line) {
  const double top = shape.reading.modulus_window_high * shape.peak;
  for (std::size_t i = 0; i <= shape.peak_row; ++i) {
    const double load = branch.smooth_load[i];
    if (load < top) continue;
    if (branch.smooth_path[i] - line.intercept > line.slope * load / (1.0 - kStiffnessLost)) {
      return {load + base_load(shape.reading), ""};
    }
  }
  return absent("the secant stiffness falls by less than a tenth before the peak");
}

}  // namespace

FeatureValue window_stiffness(const CurveShape& shape) {
  const std::string why = no_line(shape);
  if (!why.empty()) return {std::nullopt, why};
  return {1.0 / shape.line->slope, ""};
}

FeatureValue initial_stiffness(const CurveShape& shape) {
  const std::string why = no_peak(shape);
  if (!why.empty()) return {std::nullopt, why};
  const auto line =
      compliance_line(shape.branch, shape.peak_row, kInitialLow * shape.peak, kInitialHigh * shape.peak);
  if (!line) return absent("fewer than three rows lie between 0.05 and 0.2 of the peak, or they do not rise");
  return {1.0 / line->slope, ""};
}

FeatureValue late_stiffness_ratio(const CurveShape& shape) {
  const std::string why = no_line(shape);
  if (!why.empty()) return {std::nullopt, why};
  const auto line = compliance_line(shape.branch, shape.peak_row, kLateLow * shape.peak, kLateHigh * shape.peak);
  if (!line) return absent("fewer than three rows lie between 0.6 and 0.8 of the peak, or they do not rise");
  return {shape.line->slope / line->slope, ""};
}

FeatureValue toe_offset(const CurveShape& shape) {
  const std::string why = no_line(shape);
  if (!why.empty()) return {std::nullopt, why};
  return {shape.line->intercept, ""};
}

FeatureValue toe_travel(const CurveShape& shape) {
  const std::string why = no_line(shape);
  if (!why.empty()) return {std::nullopt, why};
  const auto travel = travel_of(shape.branch, *shape.line, kToeLoad * shape.peak);
  if (!travel) return absent("the curve begins above 0.02 of the peak");
  return {*travel, ""};
}

FeatureValue toe_extent(const CurveShape& shape) {
  const FeatureValue travel = toe_travel(shape);
  if (!travel.value) return travel;
  if (*travel.value < kLeastToe * loading_path(shape)) return absent("no toe: it travels less than 0.01 of the way to the peak");
  for (std::size_t i = 0; i < shape.peak_row; ++i) {
    const double load = shape.branch.smooth_load[i];
    if (load < kToeLoad * shape.peak) continue;
    if (shape.line->at(load) - shape.branch.smooth_path[i] <= kToeLeft * *travel.value) return {load / shape.peak, ""};
  }
  return absent("the toe does not end before the peak");
}

FeatureValue nonlinearity_load(const CurveShape& shape) {
  const std::string why = no_line(shape);
  if (!why.empty()) return {std::nullopt, why};
  return load_where_bent(shape, shape.branch, *shape.line);
}

namespace {

bool has_gauge(const CurveShape& shape) { return !shape.first.gauge_strain.empty(); }
bool has_lateral(const CurveShape& shape) { return !shape.first.lateral_strain.empty(); }

std::optional<ElasticResult> gauge_slopes(const CurveShape& shape) {
  const std::vector<double> nothing(shape.first.load.size(), 0.0);
  const CurveReading& r = shape.reading;
  const double base = base_load(r);
  const StressRange window{base + r.modulus_window_low * shape.peak, base + r.modulus_window_high * shape.peak};
  return elastic_slopes({shape.first.load, shape.first.gauge_strain, has_lateral(shape) ? shape.first.lateral_strain : nothing},
                        shape.peak_row, window, r.plane);
}

/// Lateral strain over path between two fractions of the peak; Eq. (F3).
std::optional<double> lateral_slope(const CurveShape& shape, double low, double high) {
  const auto rows = window_rows(shape.branch.smooth_load, shape.peak_row, low * shape.peak, high * shape.peak);
  if (rows.size() < 3) return std::nullopt;
  return slope_in_order(gather(shape.first.path, rows), gather(shape.first.lateral_strain, rows));
}

std::string no_lateral(const CurveShape& shape) {
  const std::string why = no_peak(shape);
  if (!why.empty()) return why;
  return has_lateral(shape) ? "" : "lateral_strain was not recorded";
}

}  // namespace

FeatureValue gauge_modulus(const CurveShape& shape) {
  const std::string why = no_peak(shape);
  if (!why.empty()) return {std::nullopt, why};
  if (!has_gauge(shape)) return absent("no gauge on the specimen: the strain is the platens'");
  const auto slopes = gauge_slopes(shape);
  if (!slopes) return absent("fewer than three rows lie in the modulus window");
  return {slopes->youngs_modulus_gpa, ""};
}

FeatureValue gauge_ratio(const CurveShape& shape) {
  const std::string why = no_lateral(shape);
  if (!why.empty()) return {std::nullopt, why};
  if (!has_gauge(shape)) return absent("no gauge on the specimen: the strain is the platens'");
  const auto slopes = gauge_slopes(shape);
  if (!slopes) return absent("fewer than three rows lie in the modulus window");
  return {slopes->poissons_ratio, ""};
}

FeatureValue lateral_ratio(const CurveShape& shape) {
  const std::string why = no_lateral(shape);
  if (!why.empty()) return {std::nullopt, why};
  const auto slope = lateral_slope(shape, shape.reading.modulus_window_low, shape.reading.modulus_window_high);
  if (!slope) return absent("fewer than three rows lie in the modulus window");
  return {*slope, ""};
}

FeatureValue late_lateral_ratio(const CurveShape& shape) {
  const std::string why = no_lateral(shape);
  if (!why.empty()) return {std::nullopt, why};
  const auto slope = lateral_slope(shape, kLateLow, kLateHigh);
  if (!slope) return absent("fewer than three rows lie between 0.6 and 0.8 of the peak");
  return {*slope, ""};
}

FeatureValue peak_lateral_strain(const CurveShape& shape) {
  const std::string why = no_lateral(shape);
  if (!why.empty()) return {std::nullopt, why};
  return {trailing_values(shape.first.lateral_strain, shape.smoothing_rows)[shape.peak_row], ""};
}

FeatureValue lateral_nonlinearity_load(const CurveShape& shape) {
  const std::string why = no_lateral(shape);
  if (!why.empty()) return {std::nullopt, why};
  const Branch lateral = make_branch(shape.first.lateral_strain, shape.branch.load, shape.smoothing_rows);
  const auto line = compliance_line(lateral, shape.peak_row, shape.reading.modulus_window_low * shape.peak,
                                    shape.reading.modulus_window_high * shape.peak);
  if (!line) return absent("the lateral strain does not rise in the modulus window");
  return load_where_bent(shape, lateral, *line);
}

}  // namespace asperity
