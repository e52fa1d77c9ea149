#include "app/run_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/crack_plots.hpp"
#include "app/run_frames.hpp"
#include "core/geometry/joint_profile.hpp"
#include "core/output/csv.hpp"
#include "core/output/measured_curve.hpp"
#include "core/output/summary.hpp"
#include "render/axes.hpp"
#include "render/film_strip.hpp"
#include "render/paint.hpp"
#include "render/plots.hpp"
#include "render/series.hpp"

namespace asperity::app {
namespace {

using render::PlotSeries;
using render::SeriesKind;
using render::VerticalAxis;

constexpr int kStripWidth = 2400;  // pixels

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& v : values) v *= factor;
  return values;
}

std::vector<double> sum(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
  return a;
}

/// Measured points, unless there are none of this quantity.
void add_measured(render::Plot& plot, const std::string& label, std::vector<double> x, const std::vector<double>& y,
                  VerticalAxis axis = VerticalAxis::left) {
  const auto finite = [](double v) { return std::isfinite(v); };
  if (std::none_of(y.begin(), y.end(), finite) || std::none_of(x.begin(), x.end(), finite)) return;
  plot.series.push_back({label, std::move(x), y, {SeriesKind::points, axis, {}}});
}

/// The paper's Figs 8 and 10.
void plot_shear(const CsvData& curves, const std::vector<MeasuredCurve>& measured, const std::filesystem::path& path) {
  const std::vector<double> x = curves.numbers("shear_displacement_mm");
  render::Plot plot;
  plot.title = "Shear stress and dilation against displacement";
  plot.x_label = "shear displacement [mm]";
  plot.y_label = "stress on the plan area [MPa]";
  plot.second_y_label = "dilation [mm]";
  plot.series = {{"shear stress", x, curves.numbers("shear_stress_mpa"), {}},
                 {"normal stress", x, curves.numbers("normal_stress_mpa"), {}},
                 {"dilation", x, curves.numbers("dilation_mm"), {SeriesKind::line, VerticalAxis::right, {}}}};
  for (const MeasuredCurve& m : measured) {
    add_measured(plot, m.name + ": shear stress", m.abscissa, m.stress_mpa);
    add_measured(plot, m.name + ": dilation", m.abscissa, m.dilation_mm, VerticalAxis::right);
  }
  render::write_plot(plot, path);
}

/// Rise of the upper half: of its block, and of its ends, which differ where the half bends.
void plot_dilation(const CsvData& curves, const std::vector<MeasuredCurve>& measured,
                   const std::filesystem::path& path) {
  const std::vector<double> x = curves.numbers("shear_displacement_mm");
  render::Plot plot;
  plot.title = "Dilation against displacement";
  plot.x_label = "shear displacement [mm]";
  plot.y_label = "dilation [mm]";
  plot.series = {{"upper block", x, curves.numbers("dilation_mm"), {}},
                 {"front end", x, curves.numbers("dilation_front_mm"), {}},
                 {"rear end", x, curves.numbers("dilation_rear_mm"), {}}};
  for (const MeasuredCurve& m : measured) {
    add_measured(plot, m.name, m.abscissa, m.dilation_mm);
    add_measured(plot, m.name + ": rear", m.abscissa, m.dilation_rear_mm);
  }
  render::write_plot(plot, path);
}

/// An upright line where a tooth was sheared off, as summary.json has it.
void add_failures(render::Plot& plot, const std::filesystem::path& summary, const std::vector<double>& stress) {
  if (!std::filesystem::exists(summary)) return;
  const nlohmann::ordered_json failure = read_summary(summary).failure_mode;
  if (!failure.contains("teeth")) return;
  const double top = *std::max_element(stress.begin(), stress.end());
  int number = 0;
  for (const auto& tooth : failure.at("teeth")) {
    ++number;
    if (!tooth.at("sheared_off_at_mm").is_number()) continue;
    const double at = tooth.at("sheared_off_at_mm");
    plot.series.push_back({fmt::format("tooth {} sheared off, {:.2f} mm", number, at), {at, at}, {0.0, top}, {}});
  }
}

/// What each flank bears of the shear stress.
void plot_teeth(const CsvData& curves, double length_mm, const std::filesystem::path& summary,
                const std::filesystem::path& path) {
  const std::vector<double> x = curves.numbers("shear_displacement_mm"), stress = curves.numbers("shear_stress_mpa");
  render::Plot plot;
  plot.title = "Shear stress borne by each tooth's flanks";
  plot.x_label = "shear displacement [mm]";
  plot.y_label = "share of the shear stress [MPa]";
  plot.series = {{"whole joint", x, stress, {}}};
  for (int i = 1; curves.has(fmt::format("tooth{}_leading_x_n_per_mm", i)); ++i) {
    for (const char* flank : {"leading", "trailing"}) {
      const std::vector<double> force = curves.numbers(fmt::format("tooth{}_{}_x_n_per_mm", i, flank));
      plot.series.push_back({fmt::format("tooth {}, {} flank", i, flank), x, scaled(force, 1 / length_mm), {}});
    }
  }
  add_failures(plot, summary, stress);
  render::write_plot(plot, path);
}

void plot_stress_strain(const CsvData& curves, ExperimentType type, const std::vector<MeasuredCurve>& measured,
                        const std::filesystem::path& path) {
  render::Plot plot;
  const std::vector<double> stress = curves.numbers("axial_stress_mpa");
  if (is_compression(type)) {
    plot.title = "Axial stress against strain";
    plot.x_label = "ε [%]  (axial: shortening positive; lateral: widening drawn to the left)";
    plot.y_label = "σ₁ [MPa]";
    plot.series = {{"axial, platens (closure / height)", scaled(curves.numbers("axial_strain"), 100), stress, {}},
                   {"axial, gauge on the specimen", scaled(curves.numbers("gauge_axial_strain"), 100), stress, {}},
                   {"lateral, flanks at mid-height", scaled(curves.numbers("lateral_strain"), -100), stress, {}}};
  } else {
    plot.title = "Splitting stress against platen closure";
    plot.x_label = abscissa_of(type).label;
    plot.y_label = "2P/(πDt) [MPa]";
    plot.series = {{measured.empty() ? "" : "simulated", scaled(curves.numbers("axial_strain"), 100), stress, {}}};
  }
  for (const MeasuredCurve& m : measured) {
    add_measured(plot, m.name, scaled(m.abscissa, 100), m.stress_mpa);
    add_measured(plot, m.name + ": lateral", scaled(m.lateral_strain, -100), m.stress_mpa);
  }
  render::write_plot(plot, path);
}

void plot_energy(const CsvData& energy, const Abscissa& abscissa, const std::filesystem::path& path) {
  const std::vector<double> strain = abscissae(energy, abscissa);
  const auto area = [&](const char* label, const char* column) {
    return PlotSeries{label, strain, energy.numbers(column), {SeriesKind::stacked_area, VerticalAxis::left, {}}};
  };
  render::Plot plot;
  plot.title = "Energy account";
  plot.x_label = abscissa.label;
  plot.y_label = "energy [N mm]";
  plot.series = {
      area("elastic, particles", "elastic_n_mm"),
      area("recoverable, contacts", "recoverable_n_mm"),
      area("fracture", "fracture_n_mm"),
      area("friction", "friction_n_mm"),
      area("damping", "damping_n_mm"),
      area("kinetic", "kinetic_n_mm"),
      {"external work", strain, energy.numbers("external_work_n_mm"), {SeriesKind::line, VerticalAxis::left, 0}}};
  if (energy.has("plasticity_n_mm") && energy.numbers("plasticity_n_mm").back() > 0.0) {
    plot.series.insert(plot.series.end() - 1, area("plastic strain, particles", "plasticity_n_mm"));
  }
  render::write_plot(plot, path);
}

void plot_cracks(const CsvData& curves, ExperimentType type, const std::filesystem::path& path) {
  const Abscissa abscissa = abscissa_of(type);
  const std::vector<double> strain = abscissae(curves, abscissa);
  const std::vector<double> tension = curves.numbers("cracks_tension");
  const std::vector<double> shear = curves.numbers("cracks_shear");
  const bool joint = type == ExperimentType::direct_shear;
  render::Plot plot;
  plot.title = joint ? "Broken contacts against displacement" : "Broken contacts against strain";
  plot.x_label = abscissa.label;
  plot.y_label = "broken contacts";
  plot.second_y_label = stress_label(type);
  plot.series = {{"tension", strain, tension, {}},
                 {"shear", strain, shear, {}},
                 {"all", strain, sum(tension, shear), {}},
                 {"stress", strain, curves.numbers(stress_column(type)), {SeriesKind::line, VerticalAxis::right, {}}}};
  render::write_plot(plot, path);
}

std::string panel_caption(const RunFrame& frame, ExperimentType type) {
  const bool joint = type == ExperimentType::direct_shear;
  return render::tick_label(frame.abscissa, joint ? 0.01 : 0.001) + (joint ? " mm, " : " %, ") +
         render::tick_label(frame.stress_mpa, 0.01) + " MPa";
}

}  // namespace

void draw_plots(const RunFolder& folder, const RunConfig& config) {
  const CsvData curves = read_csv(folder.curves());
  const std::vector<MeasuredCurve> measured = read_measured_curves(config);
  const ExperimentType type = config.experiment.type;
  if (type == ExperimentType::direct_shear) {
    plot_shear(curves, measured, folder.plots() / "shear_stress");
    plot_dilation(curves, measured, folder.plots() / "dilation");
    if (curves.has("tooth1_leading_x_n_per_mm"))
      plot_teeth(curves, joint_profile(config.joint).length(), folder.summary(), folder.plots() / "teeth");
  } else {
    plot_stress_strain(curves, type, measured, folder.plots() / "stress_strain");
  }
  plot_energy(read_csv(folder.energy()), abscissa_of(type), folder.plots() / "energy");
  plot_cracks(curves, type, folder.plots() / "cracks");
  draw_crack_plots(folder, config);
}

void draw_strip(const RunFolder& folder, const RunConfig& config) {
  const ExperimentType type = config.experiment.type;
  const CsvData curves = read_csv(folder.curves());
  const std::vector<RunFrame> frames = run_frames(folder.root(), curves, type);
  if (frames.empty()) return;
  std::vector<render::StripPanel> panels;
  for (const RunFrame& frame :
       telling_frames(frames, abscissae(curves, abscissa_of(type)), curves.numbers(stress_column(type))))
    panels.push_back({render::read_frame(folder.root(), frame.number), panel_caption(frame, type)});
  render::write_png(render::draw_film_strip(panels, render::Field::cracks, kStripWidth), folder.plots() / "strip.png");
}

}  // namespace asperity::app
