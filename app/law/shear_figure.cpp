#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/law/law_set.hpp"
#include "render/style.hpp"

namespace asperity::app {
namespace {

using render::Chart;
using render::style::kBlue;
using render::style::kInk;

constexpr std::array<double, 4> kPressures{0.0, 0.5, 1.0, 2.0};  // of c_c
constexpr std::array<render::Colour, 4> kPressureColours{render::style::kSky, render::style::kGreen,
                                                         render::style::kPurple, render::style::kVermilion};
constexpr render::Colour kAreaFill{0xD3, 0xE6, 0xF3};  // of style::kBlue, pale
constexpr double kBeyondBreak = 1.25;                  // of the slip of the break: that friction stays shows
constexpr double kRoomForName = 1.5;                   // of the same, where a name stands behind it
constexpr double kLoopBeyond = 1.7;                    // of the peak's slip
constexpr double kTurnBefore = 0.55, kTurnBehind = 1.35;

/// Rounded to two significant digits, so that legends can name it.
double rounded(double value) { return value == 0.0 ? 0.0 : std::stod(fmt::format("{:.1e}", value)); }

std::vector<double> pressures_of(const DrivenLaw& law) {
  std::vector<double> pressures;
  for (const double share : kPressures) pressures.push_back(rounded(share * law.parameters.c_c));
  return pressures;
}

std::string mpa(double value) { return short_number(value) + " MPa"; }

std::string pressure_name(double pressure) { return "p = " + mpa(pressure); }

Chart slip_chart(const std::string& heading) {
  Chart chart;
  chart.heading = heading;
  chart.x_label = "slip δ_{s} [mm]";
  chart.y_label = "shear traction τ [MPa]";
  return chart;
}

/// What breaks last of both laws and all pressures, mm.
double farthest_break(const LawSet& set, const std::vector<double>& pressures) {
  double farthest = 0.0;
  for (const NamedLaw* law : {&set.own, &set.other})
    for (const double p : pressures) farthest = std::max(farthest, limits_under_pressure(law->law, p).last_bonded.slip);
  return farthest;
}

Chart several_pressures(const LawSet& set, LawFigure& result) {
  Chart chart = slip_chart("slip under constant pressure");
  const std::vector<double> pressures = pressures_of(set.own.law);
  const double last = kBeyondBreak * farthest_break(set, pressures);
  std::vector<Vec2> peaks;
  for (std::size_t i = 0; i < pressures.size(); ++i) {
    const double p = pressures[i];
    const LawPath own = shear_path(set.own.law, p, last), other = shear_path(set.other.law, p, last);
    const PathPoint peak = limits_under_pressure(set.own.law, p).strongest;
    peaks.push_back({peak.slip, peak.shear_traction});
    const std::string label = pressure_name(p) + ", peak " + mpa(peak.shear_traction);
    chart.layers.emplace_back(line_of(own, PathView::slip, label, own_stroke(kPressureColours[i])));
    chart.layers.emplace_back(line_of(other, PathView::slip, "", other_stroke(kPressureColours[i])));
    add_rows(result.rows, set.own, "pressure " + mpa(p), own);
    add_rows(result.rows, set.other, "pressure " + mpa(p), other);
  }
  chart.layers.emplace_back(named_points(peaks, {}));
  chart.x_range = render::Range{0.0, last};
  return chart;
}

/// Loaded, unloaded and loaded again before the peak and behind it.
LawPath looped_path(const DrivenLaw& law, double pressure, double last) {
  const double peak = limits_under_pressure(law, pressure).first_damage.slip;
  return shear_path(law, pressure, last, {kTurnBefore * peak, kTurnBehind * peak});
}

render::LineLayer initial_stiffness(const LawParameters& p, double highest) {
  return {"initial stiffness k_{s} = " + short_number(p.k_s) + " MPa/mm",
          {0.0, highest / p.k_s},
          {0.0, highest},
          {render::style::kOrange, 2.5, {4, 6}, render::Cap::butt}};
}

Chart loops(const LawSet& set, LawFigure& result) {
  const double pressure = rounded(set.own.law.parameters.c_c);
  Chart chart = slip_chart("unloading and reloading, " + pressure_name(pressure));
  const LawLimits limits = limits_under_pressure(set.own.law, pressure);
  const double last = kLoopBeyond * std::max(limits.first_damage.slip,
                                             limits_under_pressure(set.other.law, pressure).first_damage.slip);
  const LawPath own = looped_path(set.own.law, pressure, last), other = looped_path(set.other.law, pressure, last);
  chart.layers.emplace_back(line_of(own, PathView::slip, set.own.name, own_stroke(kBlue)));
  chart.layers.emplace_back(line_of(other, PathView::slip, set.other.name, other_stroke(kInk)));
  const PathPoint& peak = limits.strongest;
  chart.layers.emplace_back(initial_stiffness(set.own.law.parameters, 0.75 * peak.shear_traction));
  chart.layers.emplace_back(
      named_points({{peak.slip, peak.shear_traction}, {last, own.back().shear_traction}},
                   {fmt::format("peak: {} mm, {} MPa", short_number(peak.slip), short_number(peak.shear_traction)),
                    short_number(own.back().shear_traction) + " MPa"}));
  chart.x_range = render::Range{0.0, last};
  chart.y_range = render::Range{0.0, 1.15 * peak.shear_traction};
  add_rows(result.rows, set.own, "unloading and reloading", own);
  add_rows(result.rows, set.other, "unloading and reloading", other);
  return chart;
}

/// Without pressure: the work that parts a unit of area in shear.
Chart energy(const LawSet& set, LawFigure& result) {
  Chart chart = slip_chart("no pressure: the energy of shear");
  const LawLimits limits = limits_under_pressure(set.own.law, 0.0);
  const LawPath bonded = shear_path(set.own.law, 0.0, limits.last_bonded.slip);
  render::BandLayer band{
      fmt::format("G_{{II}} = {} N/mm: area under the {}", short_number(loading_work(bonded)), set.own.name),
      {},
      {},
      {},
      kAreaFill};
  for (const PathPoint& p : bonded) {
    band.x.push_back(p.slip);
    band.lower.push_back(0.0);
    band.upper.push_back(p.shear_traction);
  }
  const double last = kRoomForName * farthest_break(set, {0.0});
  const LawPath own = shear_path(set.own.law, 0.0, last), other = shear_path(set.other.law, 0.0, last);
  chart.layers.emplace_back(std::move(band));
  chart.layers.emplace_back(line_of(own, PathView::slip, set.own.name, own_stroke(kBlue)));
  chart.layers.emplace_back(line_of(other, PathView::slip, set.other.name, other_stroke(kInk)));
  const PathPoint &peak = limits.strongest, &end = limits.last_bonded;
  const bool softens = end.slip > 1.01 * peak.slip;
  chart.layers.emplace_back(named_points(
      {{peak.slip, peak.shear_traction}, {end.slip, 0.0}},
      {fmt::format("δ_{{cs}} = {} mm, c_{{c}} = {} MPa", short_number(peak.slip), short_number(peak.shear_traction)),
       softens ? "δ_{us} = " + short_number(end.slip) + " mm" : "drop (Eq 6)"}));
  chart.x_range = render::Range{0.0, last};
  chart.y_range = render::Range{0.0, 1.2 * peak.shear_traction};
  add_rows(result.rows, set.own, "no pressure", own);
  return chart;
}

Chart closing(const LawSet& set, LawFigure& result) {
  const double pressure = pressures_of(set.own.law).back();
  Chart chart;
  chart.heading = "closing";
  chart.x_label = "closing −δ_{n} [mm]";
  chart.y_label = "pressure p [MPa]";
  const auto add = [&](const NamedLaw& law, const render::Stroke& stroke) {
    const LawPath path = closing_path(law.law, pressure);
    render::LineLayer line = line_of(path, PathView::opening, law.name, stroke);
    for (double& v : line.x) v = -v;
    for (double& v : line.y) v = -v;
    chart.layers.emplace_back(std::move(line));
    add_rows(result.rows, law, "closing", path);
    return -path.back().opening;
  };
  const double own = add(set.own, own_stroke(kBlue)), other = add(set.other, other_stroke(kInk));
  chart.x_range = render::Range{0.0, 1.04 * std::max(own, other)};
  chart.y_range = render::Range{0.0, 1.08 * pressure};
  return chart;
}

}  // namespace

LawFigure shear_figure(const LawSet& set) {
  LawFigure result{"compression_shear", {}, {}};
  result.figure.title = "Contact law in compression and shear: " + set.title;
  result.figure.caption = set.parameters + " Dashed in (a): " + set.other.name +
                          ", in the colour of its pressure. Arrows: unloading and reloading.";
  result.figure.charts = {several_pressures(set, result), loops(set, result), energy(set, result),
                          closing(set, result)};
  result.figure.columns = 2;
  result.figure.letters = render::Letters::each;
  result.figure.width = 2000;
  result.figure.height = 1750;
  return result;
}

}  // namespace asperity::app
