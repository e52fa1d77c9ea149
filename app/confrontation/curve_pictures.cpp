#include <algorithm>
#include <cmath>

#include "app/confrontation/confrontation_pictures.hpp"
#include "app/confrontation/mesh_band.hpp"
#include "app/confrontation/words.hpp"
#include "core/config/run_config.hpp"
#include "render/style.hpp"

namespace asperity::app {
namespace {

constexpr std::size_t kPanels = 6;      // of a figure
constexpr std::size_t kLeastTests = 3;  // that differ in their stress
constexpr int kBandPoints = 200;
constexpr double kLine = 2.5, kThin = 1.6;  // pixels
constexpr render::Colour kBaseFill{0xCF, 0xE2, 0xF0}, kExtensionFill{0xF7, 0xDC, 0xC8};

/// What the curves of an experiment stand over.
struct CurveAxes {
  double factor = 1;
  std::string x_label, y_label;
};

CurveAxes axes_of(const ShownTest& test) {
  switch (test.experiment) {
    case ExperimentType::brazilian:
      return {1, "platen displacement [mm]", "load / thickness [N/mm]"};
    case ExperimentType::direct_shear:
      return {1, "shear displacement [mm]", "shear stress [MPa]"};
    case ExperimentType::uniaxial:
    case ExperimentType::triaxial:
      break;
  }
  return {100, test.path_is_gauge ? "axial strain, gauge [%]" : "axial strain [%]", "axial stress [MPa]"};
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& v : values) v *= factor;
  return values;
}

/// How one model is drawn.
struct ModelLook {
  std::string name;
  render::Colour line, fill;
  std::vector<double> dash;
};

ModelLook base_look() { return {"base", render::style::kBlue, kBaseFill, {}}; }

ModelLook extension_look() { return {"extension", render::style::kVermilion, kExtensionFill, {12, 5}}; }

void add_band(const std::vector<ShownCurve>& curves, const ModelLook& look, double factor, render::Chart& chart) {
  const MeshBand band = mesh_band(curves, kBandPoints);
  if (band.path.empty()) return;
  chart.layers.emplace_back(render::BandLayer{look.name + ", between the meshes", scaled(band.path, factor), band.lower,
                                              band.upper, look.fill});
}

void add_lines(const std::vector<ShownCurve>& curves, const std::string& label, double factor,
               const render::Stroke& stroke, render::Chart& chart) {
  bool first = true;
  for (const ShownCurve& curve : curves) {
    if (curve.path.empty()) continue;
    chart.layers.emplace_back(render::LineLayer{first ? label : "", scaled(curve.path, factor), curve.load, stroke, 0});
    first = false;
  }
}

render::Chart curve_chart(const ShownTest& test) {
  const CurveAxes axes = axes_of(test);
  render::Chart chart{test_title(test), axes.x_label, axes.y_label, {}, {}, {}, {}};
  add_band(test.base, base_look(), axes.factor, chart);
  add_band(test.extension, extension_look(), axes.factor, chart);
  add_lines(test.base, "base, each mesh", axes.factor, {base_look().line, kThin, {}, render::Cap::butt}, chart);
  add_lines(test.extension, "extension, each mesh", axes.factor,
            {extension_look().line, kThin, extension_look().dash, render::Cap::butt}, chart);
  add_lines(test.measured, "measured specimens", axes.factor, {render::style::kInk, kLine, {}, render::Cap::butt},
            chart);
  return chart;
}

render::ChartFigure figure_of(std::vector<render::Chart> charts) {
  render::ChartFigure figure;
  figure.title = "Measured and simulated curves";
  figure.columns = charts.size() == 1 ? 1 : 2;
  const std::size_t rows = (charts.size() + 1) / 2;
  figure.height = charts.size() == 1 ? 1100 : 260 + 560 * static_cast<int>(rows);
  figure.charts = std::move(charts);
  return figure;
}

/// A model's peaks over the stress of its tests.
struct Peaks {
  std::vector<double> stress, low, high, mean;
};

void add_peaks(const std::vector<ShownCurve>& runs, const std::string& feature, double stress, Peaks& peaks) {
  std::vector<double> values;
  for (const ShownCurve& run : runs) {
    if (const auto found = run.features.find(feature); found != run.features.end()) values.push_back(found->second);
  }
  if (values.empty()) return;
  double sum = 0.0;
  for (const double v : values) sum += v;
  peaks.stress.push_back(stress);
  peaks.low.push_back(*std::min_element(values.begin(), values.end()));
  peaks.high.push_back(*std::max_element(values.begin(), values.end()));
  peaks.mean.push_back(sum / static_cast<double>(values.size()));
}

void add_band(const Peaks& peaks, const ModelLook& look, render::Chart& chart) {
  if (peaks.stress.empty()) return;
  chart.layers.emplace_back(
      render::BandLayer{look.name + ", between the meshes", peaks.stress, peaks.low, peaks.high, look.fill});
}

void add_mean(const Peaks& peaks, const ModelLook& look, render::Chart& chart) {
  if (peaks.stress.empty()) return;
  chart.layers.emplace_back(render::LineLayer{
      look.name + ", mean", peaks.stress, peaks.mean, {look.line, 4, look.dash, render::Cap::butt}, 0});
}

void add_measured(const ShownTest& test, const std::string& feature, double stress, render::PointLayer& layer) {
  const auto found = test.features.find(feature);
  if (found == test.features.end()) return;
  for (const double v : found->second) {
    if (!std::isfinite(v)) continue;
    layer.x.push_back(stress);
    layer.y.push_back(v);
  }
}

/// What of a run stands beside a measured strength, as the comparison reads it: without a curve, its largest stress.
std::string simulated_feature(const ShownTest& test, const std::string& feature) {
  return test.measured.empty() && feature == "peak_axial_stress_mpa" ? "largest_axial_stress_mpa" : feature;
}

/// A test and the stress it is drawn over.
using StressedTest = std::pair<double, const ShownTest*>;

std::optional<render::ChartFigure> peaks_figure(std::vector<StressedTest> tests, const std::string& feature,
                                                const render::Chart& axes, const std::string& title) {
  std::stable_sort(tests.begin(), tests.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::size_t different = tests.empty() ? 0 : 1;
  for (std::size_t i = 1; i < tests.size(); ++i) different += tests[i].first > tests[i - 1].first;
  if (different < kLeastTests) return std::nullopt;
  Peaks base, extension;
  render::PointLayer fitted{
      "measured, fitted", {}, {}, {render::MarkerShape::disc, render::style::kInk, 9}, {}, {}, {}};
  render::PointLayer kept{
      "measured, kept back", {}, {}, {render::MarkerShape::open_diamond, render::style::kInk, 11}, {}, {}, {}};
  for (const auto& [stress, test] : tests) {
    const std::string simulated = simulated_feature(*test, feature);
    add_peaks(test->base, simulated, stress, base);
    add_peaks(test->extension, simulated, stress, extension);
    add_measured(*test, feature, stress, test->kept_back ? kept : fitted);
  }
  render::Chart chart = axes;
  add_band(base, base_look(), chart);
  add_band(extension, extension_look(), chart);
  add_mean(base, base_look(), chart);
  add_mean(extension, extension_look(), chart);
  for (const render::PointLayer& layer : {fitted, kept}) {
    if (!layer.x.empty()) chart.layers.emplace_back(layer);
  }
  render::ChartFigure figure;
  figure.title = title;
  figure.charts = {std::move(chart)};
  return figure;
}

}  // namespace

std::vector<render::ChartFigure> curve_figures(const ConfrontationData& data) {
  std::vector<render::ChartFigure> figures;
  std::vector<render::Chart> charts;
  for (const ShownTest& test : data.tests) {
    if (test.measured.empty()) continue;
    charts.push_back(curve_chart(test));
    if (charts.size() < kPanels) continue;
    figures.push_back(figure_of(std::move(charts)));
    charts.clear();
  }
  if (!charts.empty()) figures.push_back(figure_of(std::move(charts)));
  return figures;
}

std::optional<render::ChartFigure> strength_figure(const ConfrontationData& data) {
  std::vector<StressedTest> tests;
  for (const ShownTest& test : data.tests) {
    if (test.experiment == ExperimentType::uniaxial) tests.emplace_back(0.0, &test);
    if (test.experiment == ExperimentType::triaxial && test.confining_pressure_mpa)
      tests.emplace_back(*test.confining_pressure_mpa, &test);
  }
  return peaks_figure(std::move(tests), "peak_axial_stress_mpa",
                      {"", "confining pressure σ₃ [MPa]", "peak axial stress σ₁ [MPa]", {}, {}, {}, {}},
                      "Strength against confining pressure");
}

std::optional<render::ChartFigure> joint_strength_figure(const ConfrontationData& data) {
  std::vector<StressedTest> tests;
  for (const ShownTest& test : data.tests) {
    if (test.experiment == ExperimentType::direct_shear && test.normal_stress_mpa)
      tests.emplace_back(*test.normal_stress_mpa, &test);
  }
  return peaks_figure(std::move(tests), "peak_shear_stress_mpa",
                      {"", "normal stress σₙ [MPa]", "peak shear stress [MPa]", {}, {}, {}, {}},
                      "Joint strength against normal stress");
}

}  // namespace asperity::app
