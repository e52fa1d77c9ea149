#include "app/crack_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/run_frames.hpp"
#include "core/measurement/crack_rose.hpp"
#include "core/measurement/fragment_sizes.hpp"
#include "render/charts.hpp"
#include "render/paint.hpp"
#include "render/rose_plot.hpp"
#include "render/style.hpp"

namespace asperity::app {
namespace {

constexpr int kSectors = 18;  // of 10 degrees

/// The directions and lengths of the cracks of one mode.
struct ModeCracks {
  std::vector<double> orientation_deg, length_mm;
  double length() const { return std::accumulate(length_mm.begin(), length_mm.end(), 0.0); }
};

ModeCracks cracks_of(const CsvData& table, const std::string& mode) {
  const std::vector<std::string> modes = table.words("mode");
  const std::vector<double> orientation = table.numbers("orientation_deg"), length = table.numbers("length_mm");
  ModeCracks cracks;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (modes[i] != mode) continue;
    cracks.orientation_deg.push_back(orientation[i]);
    cracks.length_mm.push_back(length[i]);
  }
  return cracks;
}

render::Rose rose_of(const ModeCracks& cracks, const std::string& name, render::Colour fill) {
  return {fmt::format("{}: {} cracks, {:.3g} mm", name, cracks.length_mm.size(), cracks.length()),
          rose_lengths(cracks.orientation_deg, cracks.length_mm, kSectors), fill};
}

void draw_rose(const RunFolder& folder, const RunConfig& config) {
  const CsvData table = read_csv(folder.crack_table());
  if (table.rows() == 0) return;
  const bool joint = config.experiment.type == ExperimentType::direct_shear;
  render::RosePlot plot;
  plot.title = "Directions of the cracks";
  plot.caption =
      "Crack length at rest by direction, in sectors of 10°; a sector's area is its share of the mode's length "
      "(rings), and "
      "it is drawn at both ends. Angles from the x axis. Edges of a triangle mesh zigzag by some 30° about a straight "
      "crack.";
  plot.roses = {rose_of(cracks_of(table, "tension"), "Tension", render::style::kTension),
                rose_of(cracks_of(table, "shear"), "Shear", render::style::kShear)};
  plot.axis_deg = joint ? 0.0 : 90.0;
  plot.axis_label = joint ? "joint" : "load";
  std::vector<std::vector<CsvCell>> rows;
  const double width = 180.0 / kSectors;
  for (int i = 0; i < kSectors; ++i)
    rows.push_back({width * i, width * (i + 1), plot.roses[0].sectors[i], plot.roses[1].sectors[i]});
  write_plot_files(folder, "crack_rose", render::draw_roses(plot),
                   {"from_deg", "to_deg", "tension_length_mm", "shear_length_mm"}, rows);
}

/// Both sides of every step, in decadic logarithms of the size.
render::LineLayer passing_line(const std::vector<PassingStep>& curve) {
  render::LineLayer line{
      "share of the area in fragments no larger", {}, {}, {render::style::kBlue, 5, {}, render::Cap::butt}};
  double before = 0.0;
  for (const PassingStep& step : curve) {
    const double at = std::log10(step.size_mm);
    line.x.insert(line.x.end(), {at, at});
    line.y.insert(line.y.end(), {100 * before, 100 * step.share});
    before = step.share;
  }
  return line;
}

void draw_fragments(const RunFolder& folder) {
  if (!std::filesystem::exists(folder.fragments())) return;  // runs of before the table
  const std::vector<double> areas = read_csv(folder.fragments()).numbers("area_mm2");
  if (areas.size() < 2) return;
  const std::vector<PassingStep> curve = passing_curve(areas);
  const double d50 = passing_size(areas, 0.5), d80 = passing_size(areas, 0.8);
  render::Chart chart;
  chart.x_label = "size √(4A/π) [mm]";
  chart.y_label = "passing [% of area]";
  chart.layers.emplace_back(passing_line(curve));
  chart.layers.emplace_back(
      render::PointLayer{"",
                         {std::log10(d50), std::log10(d80)},
                         {50, 80},
                         {render::MarkerShape::ring, render::style::kInk, 7},
                         {},
                         {},
                         d50 == d80 ? std::vector<std::string>{"", fmt::format("d_{{50}} = d_{{80}} = {:.3g} mm", d80)}
                                    : std::vector<std::string>{fmt::format("d_{{50}} = {:.3g} mm", d50),
                                                               fmt::format("d_{{80}} = {:.3g} mm", d80)}});
  chart.x_log = true;
  chart.x_range = render::widened({std::log10(curve.front().size_mm), std::log10(curve.back().size_mm)}, 0.12);
  chart.y_range = render::Range{0, 108};
  render::ChartFigure figure;
  figure.title = fmt::format("Sizes of the {} fragments at the end", areas.size());
  figure.caption =
      "A fragment is what unbroken contacts hold together; its size is the diameter of the disc of its area. The last "
      "step is "
      "the largest fragment.";
  figure.charts = {chart};
  figure.height = 1000;
  std::vector<std::vector<CsvCell>> rows;
  for (const PassingStep& step : curve) rows.push_back({step.size_mm, step.share});
  write_plot_files(folder, "fragment_sizes", render::draw_figure(figure), {"size_mm", "passing_share"}, rows);
}

}  // namespace

void write_plot_files(const RunFolder& folder, const char* name, const render::Drawing& drawing,
                      const std::vector<std::string>& columns, const std::vector<std::vector<CsvCell>>& rows) {
  const std::string path = (folder.plots() / name).string();
  render::write_png(drawing, path + ".png");
  render::write_svg(drawing, path + ".svg");
  write_csv(path + ".csv", columns, rows);
}

std::size_t peak_row(const CsvData& curves, const RunConfig& config) {
  const std::vector<double> stress = curves.numbers(stress_column(config.experiment.type)),
                            strain = curves.numbers("axial_strain");
  std::size_t peak = 0;
  for (std::size_t i = 0; i < stress.size() && strain[i] <= config.measurement.peak_strain_limit; ++i)
    if (stress[i] > stress[peak]) peak = i;
  return peak;
}

void draw_crack_plots(const RunFolder& folder, const RunConfig& config) {
  const CsvData curves = read_csv(folder.curves());
  draw_rose(folder, config);
  draw_event_plots(folder, config, curves);
  draw_volumetric_plot(folder, config, curves);
  draw_fragments(folder);
}

}  // namespace asperity::app
