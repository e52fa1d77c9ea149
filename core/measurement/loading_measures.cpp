#include <algorithm>

#include "core/measurement/feature_parts.hpp"
#include "core/measurement/results.hpp"

namespace asperity {

using namespace feature_limits;
using namespace feature_parts;

namespace {

/// Load at which the line, bent by the share of stiffness that may be lost, meets the curve; Eq. (F11).
FeatureValue load_where_bent(const CurveShape& shape, const Branch& branch, const Line& line) {
  const auto from = find_crossing(shape.branch, shape.reading.modulus_window_high * shape.peak, Direction::rising, 0,
                                  shape.peak_row + 1);
  if (!from) return absent("the curve begins above the modulus window");
  std::vector<bool> bent;
  for (std::size_t i = from->row; i <= shape.peak_row; ++i) {
    const double straight = line.slope * branch.smooth_load[i] / (1.0 - kStiffnessLost);
    bent.push_back(branch.smooth_path[i] - line.intercept > straight);
  }
  const std::size_t row = parting_row(bent);
  if (row >= bent.size()) return absent("the secant stiffness falls by less than a tenth before the peak");
  return {branch.smooth_load[from->row + row] + base_load(shape.reading), ""};
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
  const auto line = compliance_line(shape.branch, shape.peak_row, kInitialLow * shape.peak, kInitialHigh * shape.peak);
  if (!line) return absent("fewer than three rows lie between 0.05 and 0.2 of the peak, or they do not rise");
  return {1.0 / line->slope, ""};
}

FeatureValue late_stiffness_ratio(const CurveShape& shape) {
  const std::string why = no_line(shape);
  if (!why.empty()) return {std::nullopt, why};
  const auto line = compliance_line(shape.branch, shape.peak_row, kLateLow * shape.peak, kLateHigh * shape.peak);
  if (!line) return absent("fewer than three rows lie between 0.55 and 0.85 of the peak, or they do not rise");
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
  if (*travel.value < kLeastToe * loading_path(shape))
    return absent("no toe: it travels less than 0.01 of the way to the peak");
  const double low = kToeLoad * shape.peak, high = shape.reading.modulus_window_high * shape.peak;
  const auto from = find_crossing(shape.branch, low, Direction::rising, 0, shape.peak_row + 1);
  const auto to = find_crossing(shape.branch, high, Direction::rising, 0, shape.peak_row + 1);
  if (!from || !to) return absent("the curve begins above the toe");
  const std::vector<double>& load = shape.branch.smooth_load;
  const auto gap = [&](std::size_t i) { return shape.line->at(load[i]) - shape.branch.smooth_path[i]; };
  double area = *travel.value * (load[from->row] - low);
  for (std::size_t i = from->row; i < to->row; ++i) area += 0.5 * (gap(i) + gap(i + 1)) * (load[i + 1] - load[i]);
  return {area / (*travel.value * shape.peak), ""};
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
  const std::vector<double>& gauge = shape.first.gauge_strain;
  const double noise = r.path_noise * *std::max_element(gauge.begin(), gauge.end());
  const double base = base_load(r);
  const StressRange window{base + r.modulus_window_low * shape.peak, base + r.modulus_window_high * shape.peak};
  return elastic_slopes({shape.first.load, gauge, has_lateral(shape) ? shape.first.lateral_strain : nothing, noise},
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
  if (!slope) return absent("fewer than three rows lie between 0.55 and 0.85 of the peak");
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
