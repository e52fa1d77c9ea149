#include <fmt/format.h>

#include <algorithm>

#include "app/crack_plots.hpp"
#include "core/measurement/crack_stresses.hpp"
#include "render/charts.hpp"
#include "render/style.hpp"

namespace asperity::app {
namespace {

using render::Chart;
using render::LineLayer;
using render::style::kBlue;
using render::style::kInk;

constexpr double kLineWidth = 4;  // pixels

/// A compression test's columns up to its peak.
struct Columns {
  std::vector<double> path, stress, axial, lateral;
  CompressionColumns view() const { return {path, {stress, axial, lateral}}; }
};

Columns columns_up_to(const CsvData& curves, std::size_t peak) {
  const auto head = [&](const char* name) {
    std::vector<double> values = curves.numbers(name);
    values.resize(peak + 1);
    return values;
  };
  return {head("platen_displacement_mm"), head("axial_stress_mpa"), head("gauge_axial_strain"), head("lateral_strain")};
}

std::vector<double> percent(std::vector<double> values) {
  for (double& v : values) v *= 100;
  return values;
}

render::PointLayer mark(double x, double y, const std::string& name) {
  return {"", {x}, {y}, {render::MarkerShape::ring, kInk, 7}, {}, {}, {name}};
}

/// A mark where cracks begin and one where the area turns, where the curve comes to them.
void add_marks(Chart& chart, const CrackStresses& found, const std::vector<double>& axial, const std::vector<double>& y,
               bool with_stress) {
  const auto add = [&](const std::optional<double>& stress, std::size_t row, const std::string& symbol) {
    if (!stress) return;
    const std::string name = with_stress ? symbol + fmt::format(" = {:.3g} MPa", *stress) : symbol;
    chart.layers.emplace_back(mark(axial[row], y[row], name));
  };
  add(found.initiation_mpa, found.initiation_row, "σ_{ci}");
  add(found.damage_mpa, found.damage_row, "σ_{cd}");
}

Chart stress_chart(const Columns& columns, const CrackStresses& found) {
  const std::vector<double> axial = percent(columns.axial), lateral = percent(columns.lateral);
  Chart chart;
  chart.heading = "stress";
  chart.y_label = "σ₁ [MPa]";
  chart.layers.emplace_back(
      LineLayer{"over the axial strain", axial, columns.stress, {kInk, kLineWidth, {}, render::Cap::butt}});
  chart.layers.emplace_back(LineLayer{"over the lateral strain (widening)",
                                      lateral,
                                      columns.stress,
                                      {render::style::kGreen, kLineWidth, {22, 10}, render::Cap::butt}});
  add_marks(chart, found, axial, columns.stress, true);
  return chart;
}

Chart strain_chart(const std::string& heading, const std::string& label, const Columns& columns,
                   const std::vector<double>& strain, const CrackStresses& found) {
  const std::vector<double> axial = percent(columns.axial), y = percent(strain);
  Chart chart;
  chart.heading = heading + ", contraction positive";
  chart.y_label = label;
  chart.layers.emplace_back(LineLayer{"", axial, y, {kBlue, kLineWidth, {}, render::Cap::butt}});
  add_marks(chart, found, axial, y, false);
  return chart;
}

std::string caption_of(const CrackStresses& found) {
  std::string caption =
      "After Martin & Chandler (1994), in two dimensions: ε_{v} = ε_{a} − ε_{l}; ε_{vc} = ε_{v} less the elastic (1 − "
      "ν′)(σ₁ − σ₃)/E′. σ_{cd}: reversal of ε_{v}; σ_{ci}: ε_{vc} has left its largest value by 2 % of the largest "
      "contraction.";
  if (!found.damage_mpa) caption += " ε_{v} does not turn before the peak.";
  if (!found.initiation_mpa) caption += " ε_{vc} does not leave its largest value by so much.";
  return caption;
}

}  // namespace

void draw_volumetric_plot(const RunFolder& folder, const RunConfig& config, const CsvData& curves) {
  if (!is_compression(config.experiment.type) || curves.rows() == 0) return;
  const std::size_t peak = peak_row(curves, config);
  const Columns columns = columns_up_to(curves, peak);
  const auto found = crack_stresses(columns.view(), peak, elastic_window(config, columns.stress[peak]),
                                    config.experiment.confining_pressure_mpa);
  if (!found) return;
  render::ChartFigure figure;
  figure.title = "Volumetric strain up to the peak";
  figure.caption = caption_of(*found);
  figure.charts = {stress_chart(columns, *found),
                   strain_chart("volumetric strain", "ε_{v} [%]", columns, found->volumetric, *found),
                   strain_chart("crack volumetric strain", "ε_{vc} [%]", columns, found->crack_volumetric, *found)};
  figure.charts.back().x_label = "axial strain ε_{a} [%]";
  const double end = 1.03 * render::range_of(percent(columns.axial)).high;
  for (Chart& chart : figure.charts) chart.x_range = render::Range{0.0, end};
  figure.letters = render::Letters::each;
  figure.height = 1700;
  std::vector<std::vector<CsvCell>> rows;
  for (std::size_t i = 0; i <= peak; ++i)
    rows.push_back(
        {columns.axial[i], columns.lateral[i], columns.stress[i], found->volumetric[i], found->crack_volumetric[i]});
  write_plot_files(
      folder, "volumetric_strain", render::draw_figure(figure),
      {"gauge_axial_strain", "lateral_strain", "axial_stress_mpa", "volumetric_strain", "crack_volumetric_strain"},
      rows);
}

}  // namespace asperity::app
