#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "app/law/law_set.hpp"
#include "core/base/units.hpp"
#include "render/style.hpp"

namespace asperity::app {
namespace {

using render::Chart;
using render::LineLayer;
using render::style::kBlue;
using render::style::kInk;

constexpr int kDirections = 90, kPressures = 60;
constexpr double kLargestPressure = 2.0;  // of c_c, or t_c where that is more
constexpr double kQuarterTurn = 0.5 * std::numbers::pi;
constexpr std::array<double, 4> kModes{0.0, 30.0, 60.0, 90.0};  // degrees
constexpr std::array<render::Colour, 4> kModeColours{render::style::kSky, render::style::kOrange, render::style::kGreen,
                                                     render::style::kPurple};

/// Limits of one law over all directions of opening and over pressures, as curves.
struct Limits {
  std::vector<LawLimits> open, closed;
  std::vector<double> pressures;
};

Limits limits_of(const DrivenLaw& law) {
  Limits limits;
  for (int i = 0; i <= kDirections; ++i) limits.open.push_back(limits_in_opening(law, kQuarterTurn * i / kDirections));
  const double largest = kLargestPressure * std::max(law.parameters.c_c, law.parameters.t_c);
  for (int i = 0; i <= kPressures; ++i) {
    limits.pressures.push_back(largest * i / kPressures);
    limits.closed.push_back(limits_under_pressure(law, limits.pressures.back()));
  }
  return limits;
}

using Part = PathPoint LawLimits::*;

/// One limit from pure opening through pure slip to the largest pressure.
LawPath curve_of(const Limits& limits, Part part) {
  LawPath path;
  for (const LawLimits& l : limits.open) path.push_back(l.*part);
  for (const LawLimits& l : limits.closed) path.push_back(l.*part);
  return path;
}

LineLayer strength_line(const LawPath& path, const std::string& label, const render::Stroke& stroke) {
  LineLayer line{label, {}, {}, stroke};
  for (const PathPoint& p : path) {
    line.x.push_back(-p.normal_traction);
    line.y.push_back(std::abs(p.shear_traction));
  }
  return line;
}

/// Slope of the last part of a line over the pressure, degrees.
double slope_deg(const LineLayer& line) {
  const std::size_t b = line.x.size() - 1, a = b - 5;
  return std::atan((line.y[b] - line.y[a]) / (line.x[b] - line.x[a])) / units::kRadPerDeg;
}

LineLayer friction_line(const Limits& limits) {
  LineLayer line{"friction left after the break", {}, {}, {render::style::kVermilion, 4, {4, 7}, render::Cap::butt}};
  for (std::size_t i = 0; i < limits.closed.size(); ++i) {
    line.x.push_back(limits.pressures[i]);
    line.y.push_back(limits.closed[i].friction);
  }
  return line;
}

Chart strength_chart(const LawSet& set, const Limits& own, const Limits& other) {
  Chart chart;
  chart.heading = "strength";
  chart.x_label = "normal stress σ [MPa], compression positive";
  chart.y_label = "shear traction |τ| [MPa]";
  const LineLayer line = strength_line(curve_of(own, &LawLimits::strongest), set.own.name, own_stroke(kBlue));
  const double slope = slope_deg(line);
  const std::size_t far = line.x.size() - 12;
  const PathPoint shear = own.closed.front().strongest, tension = own.open.front().strongest;
  chart.layers.emplace_back(friction_line(own));
  chart.layers.emplace_back(line);
  chart.layers.emplace_back(strength_line(curve_of(other, &LawLimits::strongest), set.other.name, other_stroke(kInk)));
  chart.layers.emplace_back(
      named_points({{-tension.normal_traction, 0.0}, {0.0, shear.shear_traction}, {line.x[far], line.y[far]}},
                   {"t_{c} = " + short_number(tension.normal_traction) + " MPa",
                    "c_{c} = " + short_number(shear.shear_traction) + " MPa", fmt::format("slope {:.1f}°", slope)}));
  return chart;
}

LineLayer separation_line(const LawPath& path, const std::string& label, const render::Stroke& stroke) {
  LineLayer line{label, {}, {}, stroke};
  for (const PathPoint& p : path) {
    line.x.push_back(p.opening);
    line.y.push_back(p.slip);
  }
  return line;
}

void add_separations(Chart& chart, const LawSet& set, const Limits& own, const Limits& other) {
  chart.x_label = "opening δ_{n} [mm], closing negative";
  chart.y_label = "slip δ_{s} [mm]";
  const auto add = [&](const Limits& limits, Part part, const std::string& label, const render::Stroke& stroke) {
    chart.layers.emplace_back(separation_line(curve_of(limits, part), label, stroke));
  };
  add(own, &LawLimits::first_damage, "damage begins, " + set.own.name, own_stroke(render::style::kGreen));
  add(own, &LawLimits::last_bonded, "bond broken, " + set.own.name, own_stroke(render::style::kPurple));
  add(other, &LawLimits::first_damage, "damage begins, " + set.other.name, other_stroke(render::style::kGreen));
  add(other, &LawLimits::last_bonded, "bond broken, " + set.other.name, other_stroke(render::style::kPurple));
}

Chart separation_chart(const LawSet& set, const Limits& own, const Limits& other) {
  Chart chart;
  chart.heading = "where damage begins and ends";
  add_separations(chart, set, own, other);
  const double end = own.open.front().last_bonded.opening;
  chart.layers.emplace_back(named_points({{end, 0.0}}, {"δ_{ut} = " + short_number(end) + " mm"}));
  return chart;
}

double largest_slip(const Limits& limits, Part part) {
  double largest = 0.0;
  for (const PathPoint& p : curve_of(limits, part)) largest = std::max(largest, p.slip);
  return largest;
}

Chart near_damage_chart(const LawSet& set, const Limits& own, const Limits& other) {
  Chart chart;
  chart.heading = "the same near the origin";
  add_separations(chart, set, own, other);
  const PathPoint opening = own.open.front().first_damage, slip = own.closed.front().first_damage;
  chart.layers.emplace_back(named_points(
      {{opening.opening, 0.0}, {0.0, slip.slip}},
      {"δ_{ct} = " + short_number(opening.opening) + " mm", "δ_{cs} = " + short_number(slip.slip) + " mm"}));
  const double reach =
      1.25 * std::max(largest_slip(own, &LawLimits::first_damage), largest_slip(other, &LawLimits::first_damage));
  chart.x_range = render::Range{1.05 * own.closed.back().first_damage.opening, 2.6 * opening.opening};
  chart.y_range = render::Range{0.0, reach};
  return chart;
}

/// Traction along proportional openings over the way.
Chart traction_chart(const LawSet& set, LawFigure& result) {
  Chart chart;
  chart.heading = "traction along mixed openings";
  chart.x_label = "way √(δ_{n}² + δ_{s}²) [mm]";
  chart.y_label = "traction √(σ² + τ²) [MPa]";
  const auto add = [&](const NamedLaw& law, double degrees, const std::string& label, const render::Stroke& stroke) {
    const LawPath path = mixed_path(law.law, degrees * units::kRadPerDeg);
    LineLayer line{label, {}, {}, stroke};
    for (const PathPoint& p : path) {
      line.x.push_back(std::hypot(p.opening, p.slip));
      line.y.push_back(std::hypot(p.normal_traction, p.shear_traction));
    }
    chart.layers.emplace_back(std::move(line));
    add_rows(result.rows, law, fmt::format("mixed opening {:g} degrees", degrees), path);
  };
  for (std::size_t i = 0; i < kModes.size(); ++i) {
    add(set.own, kModes[i], fmt::format("mode {:g}°", kModes[i]), own_stroke(kModeColours[i]));
    add(set.other, kModes[i], "", other_stroke(kModeColours[i]));
  }
  const LawParameters& p = set.own.law.parameters;
  chart.x_range = render::Range{0.0, 3.5 * std::max(p.delta_ct, p.delta_cs)};
  return chart;
}

LawFigure two_charts(const std::string& name, const std::string& title) {
  LawFigure result{name, {}, {}};
  result.figure.title = title;
  result.figure.columns = 2;
  result.figure.letters = render::Letters::each;
  result.figure.width = 2000;
  result.figure.height = 1100;
  return result;
}

}  // namespace

LawFigure strength_figure(const LawSet& set) {
  const Limits own = limits_of(set.own.law), other = limits_of(set.other.law);
  LawFigure result = two_charts("strength", "Strength of the contact: " + set.title);
  result.figure.caption =
      set.parameters +
      " Mode: angle in the plane of δ_{n}/δ_{ct} and δ_{s}/δ_{cs}; 0° is pure opening, 90° pure slip of "
      "an open contact. Dashed in (b): " +
      set.other.name + ", in the colour of its mode.";
  result.figure.charts = {strength_chart(set, own, other), traction_chart(set, result)};
  for (const auto& [law, limits] : {std::pair{&set.own, &own}, std::pair{&set.other, &other}})
    add_rows(result.rows, *law, "strength", curve_of(*limits, &LawLimits::strongest));
  return result;
}

LawFigure damage_figure(const LawSet& set) {
  const Limits own = limits_of(set.own.law), other = limits_of(set.other.law);
  LawFigure result = two_charts("damage", "Damage of the contact over opening and slip: " + set.title);
  result.figure.caption =
      set.parameters +
      " Opening and slip grow in a fixed proportion, or slip grows at constant closing. Where the two "
      "curves of a law lie on one another, the contact drops (Eq 6).";
  result.figure.charts = {separation_chart(set, own, other), near_damage_chart(set, own, other)};
  for (const auto& [law, limits] : {std::pair{&set.own, &own}, std::pair{&set.other, &other}}) {
    add_rows(result.rows, *law, "damage begins", curve_of(*limits, &LawLimits::first_damage));
    add_rows(result.rows, *law, "bond broken", curve_of(*limits, &LawLimits::last_bonded));
  }
  return result;
}

}  // namespace asperity::app
