#include "render/fit_plots.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "render/style.hpp"

namespace asperity::render {
namespace {

constexpr double kRadius = 9, kReferenceWidth = 3;  // pixels
constexpr double kNotable = 2;                      // standard deviations beyond which a run is named
constexpr Colour kBandFill{0xE6, 0xEE, 0xF3};

Marker run_marker() { return {MarkerShape::disc, style::kBlue, kRadius}; }
Marker centre_marker() { return {MarkerShape::ring, style::kVermilion, kRadius}; }
Stroke reference(std::vector<double> dash) { return {style::kInk, kReferenceWidth, std::move(dash), Cap::butt}; }

bool is_centre(const FittedResponse& r, std::size_t i) {
  return i < r.points.size() && r.points[i].kind == DesignPointKind::centre;
}

std::string name_of(const FittedResponse& r, std::size_t i) {
  const bool notable = i < r.studentised.size() && std::abs(r.studentised[i]) > kNotable && i < r.rows.size();
  return notable ? "run " + std::to_string(r.rows[i]) : "";
}

/// Adds the runs in two layers, the centre points apart.
void add_runs(Chart& chart, const FittedResponse& r, const std::vector<double>& x, const std::vector<double>& y) {
  PointLayer runs{"runs of the design", {}, {}, run_marker(), {}, {}, {}};
  PointLayer centres{"centre points", {}, {}, centre_marker(), {}, {}, {}};
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    PointLayer& layer = is_centre(r, i) ? centres : runs;
    layer.x.push_back(x[i]);
    layer.y.push_back(y[i]);
    layer.names.push_back(name_of(r, i));
  }
  for (PointLayer& layer : std::array{runs, centres})
    if (!layer.x.empty()) chart.layers.emplace_back(std::move(layer));
}

/// Lines at zero and at two standard deviations, over the chart's x range.
void add_residual_lines(Chart& chart, Range x) {
  chart.layers.emplace_back(LineLayer{"", {x.low, x.high}, {0, 0}, reference({})});
  for (const double y : {-kNotable, kNotable})
    chart.layers.emplace_back(LineLayer{"± 2 standard deviations", {x.low, x.high}, {y, y}, reference({8, 8})});
}

Range residual_range(const FittedResponse& r) {
  constexpr double kAtLeast = 3;
  const Range range = range_of(r.studentised);
  const double most = 1.1 * std::max({kAtLeast, -range.low, range.high});
  return {-most, most};
}

Chart residual_chart(const FittedResponse& r, const std::vector<double>& x, const std::string& x_label) {
  Chart chart{"", x_label, "studentised residual [–]", {}, {}, residual_range(r), {}};
  chart.x_range = widened(range_of(x), 0.06);
  add_residual_lines(chart, *chart.x_range);
  add_runs(chart, r, x, r.studentised);
  return chart;
}

/// The standard normal distribution's quantile: Newton's method on the error function, from the middle.
double normal_quantile(double probability) {
  double z = 0;
  for (int i = 0; i < 50; ++i) {
    const double below = 0.5 * std::erfc(-z / std::numbers::sqrt2);
    const double density = std::exp(-0.5 * z * z) / std::sqrt(2 * std::numbers::pi);
    z -= std::clamp((below - probability) / density, -1.0, 1.0);
  }
  return z;
}

/// Blom's score of each value: the normal quantile of (rank - 3/8) / (n + 1/4).
std::vector<double> normal_scores(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> scores(values.size());
  const double n = static_cast<double>(values.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    scores[order[k]] = normal_quantile((static_cast<double>(k) + 1 - 0.375) / (n + 0.25));
  return scores;
}

/// The band around the 1:1 line, in so many points that its cut at the frame is where it should be.
BandLayer scatter_band(Range x, double half_width) {
  constexpr int kPoints = 200;
  BandLayer band{"± 2 standard deviations of the residuals", {}, {}, {}, kBandFill};
  for (int i = 0; i < kPoints; ++i) {
    const double at = x.low + (x.high - x.low) * i / (kPoints - 1);
    band.x.push_back(at);
    band.lower.push_back(at - half_width);
    band.upper.push_back(at + half_width);
  }
  return band;
}

}  // namespace

Chart predicted_against_simulated(const FittedResponse& r) {
  const Range all = widened(united(range_of(r.simulated), range_of(r.fitted)), 0.08);
  Chart chart{r.heading, "simulated " + r.label, "predicted " + r.label, {}, all, all, {}};
  const std::vector<double> ends{all.low, all.high};
  if (r.residual_sd > 0) chart.layers.emplace_back(scatter_band(all, kNotable * r.residual_sd));
  chart.layers.emplace_back(LineLayer{"predicted = simulated", ends, ends, reference({})});
  add_runs(chart, r, r.simulated, r.fitted);
  return chart;
}

Chart normal_probability(const FittedResponse& r) {
  const std::vector<double> scores = normal_scores(r.studentised);
  Chart chart{"Normal probability", "normal score [–]", "studentised residual [–]", {}, {}, residual_range(r), {}};
  chart.x_range = widened(range_of(scores), 0.08);
  const std::vector<double> ends{chart.x_range->low, chart.x_range->high};
  chart.layers.emplace_back(LineLayer{"normal distribution", ends, ends, reference({14, 8})});
  add_runs(chart, r, scores, r.studentised);
  return chart;
}

Chart residual_against_fitted(const FittedResponse& r) {
  Chart chart = residual_chart(r, r.fitted, "fitted " + r.label);
  chart.heading = "Against fitted value";
  return chart;
}

Chart residual_against_row(const FittedResponse& r) {
  Chart chart = residual_chart(r, {r.rows.begin(), r.rows.end()}, "run [–]");
  chart.heading = "In order of runs";
  return chart;
}

}  // namespace asperity::render
