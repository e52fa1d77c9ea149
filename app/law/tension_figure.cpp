#include <fmt/format.h>

#include <algorithm>

#include "app/law/law_set.hpp"
#include "render/style.hpp"

namespace asperity::app {
namespace {

using render::Chart;
using render::style::kBlue;
using render::style::kInk;

constexpr render::Colour kAreaFill{0xD3, 0xE6, 0xF3};  // of style::kBlue, pale
constexpr double kBeyondEnd = 1.4;                     // of delta_ut: that nothing is left shows
constexpr double kNearPeak = 3.4;                      // of delta_ct: the second chart
constexpr double kClosingShown = 0.45;                 // of delta_ct: of the second chart's left part

/// Where a contact is opened to, closed to zero and opened again: while hardening, early and late in softening.
std::vector<double> turning_points(const LawParameters& p) {
  const double softening = p.delta_ut - p.delta_ct;
  return {0.55 * p.delta_ct, p.delta_ct + std::min(1.3 * p.delta_ct, 0.2 * softening), p.delta_ct + 0.45 * softening};
}

/// The first time a path comes to an opening.
PathPoint at_opening(const LawPath& path, double opening) {
  return *std::find_if(path.begin(), path.end(), [&](const PathPoint& p) { return p.opening >= opening; });
}

/// The driven paths of one law.
struct Tension {
  LawPath virgin, looped, closing;
  LawLimits limits;
};

Tension drive_tension(const DrivenLaw& law) {
  const LawParameters& p = law.parameters;
  const double end = kBeyondEnd * p.delta_ut;
  return {opening_path(law, end, {}, {p.delta_ct, p.delta_ut}),
          opening_path(law, end, turning_points(p), {p.delta_ct, p.delta_ut}),
          closing_path(law, p.k_t * kClosingShown * p.delta_ct), limits_in_opening(law, 0.0)};
}

render::BandLayer area_under(const NamedLaw& law, const LawPath& virgin) {
  render::BandLayer band{
      fmt::format("G_{{f}} = {} N/mm: area under the {}", short_number(loading_work(virgin)), law.name),
      {},
      {},
      {},
      kAreaFill};
  for (const PathPoint& p : virgin) {
    if (!band.x.empty() && p.opening <= band.x.back()) continue;
    band.x.push_back(p.opening);
    band.lower.push_back(0.0);
    band.upper.push_back(p.normal_traction);
  }
  return band;
}

/// Keeps the arrows of so many loops from one on; one loop has two.
render::LineLayer with_loops(render::LineLayer line, std::size_t first, std::size_t count) {
  const auto begin = line.arrows.begin() + static_cast<std::ptrdiff_t>(2 * first);
  line.arrows = {begin, begin + static_cast<std::ptrdiff_t>(2 * count)};
  return line;
}

/// Arrows stand on the loops that the chart shows well: of the other law on the one that differs.
struct ShownLoops {
  std::size_t own_first, own_count, other_count;
};

void add_laws(Chart& chart, const LawSet& set, const Tension& own, const Tension& other, const ShownLoops& shown) {
  chart.x_label = "opening δ_{n} [mm]";
  chart.y_label = "normal traction σ [MPa], tension positive";
  chart.layers.emplace_back(area_under(set.own, own.virgin));
  chart.layers.emplace_back(with_loops(line_of(own.looped, PathView::opening, set.own.name, own_stroke(kBlue)),
                                       shown.own_first, shown.own_count));
  chart.layers.emplace_back(
      with_loops(line_of(other.looped, PathView::opening, set.other.name, other_stroke(kInk)), 0, shown.other_count));
}

/// The whole curve: where it ends, and the way back with its damage.
Chart whole_curve(const LawSet& set, const Tension& own, const Tension& other) {
  Chart chart;
  chart.heading = "opening to the end";
  chart.x_range = render::Range{0.0, own.virgin.back().opening};
  add_laws(chart, set, own, other, {2, 1, 0});
  const PathPoint turn = at_opening(own.virgin, turning_points(set.own.law.parameters).back());
  const double end = own.limits.last_bonded.opening;
  chart.layers.emplace_back(
      named_points({{own.limits.strongest.opening, own.limits.strongest.normal_traction},
                    {turn.opening, turn.normal_traction},
                    {end, 0.0}},
                   {"t_{c} = " + short_number(own.limits.strongest.normal_traction) + " MPa",
                    "δ_{max}, D = " + fmt::format("{:.2f}", turn.damage), "δ_{ut} = " + short_number(end) + " mm"}));
  return chart;
}

render::LineLayer initial_stiffness(const LawParameters& p) {
  const double reach = 0.62 * p.delta_ct;
  return {"initial stiffness k_{t} = " + short_number(p.k_t) + " MPa/mm",
          {-kClosingShown * p.delta_ct, reach},
          {-kClosingShown * p.delta_ct * p.k_t, reach * p.k_t},
          {render::style::kVermilion, 2.5, {4, 6}, render::Cap::butt}};
}

Chart near_peak(const LawSet& set, const Tension& own, const Tension& other) {
  const LawParameters& p = set.own.law.parameters;
  Chart chart;
  chart.heading = "up to the peak and just behind it; closing";
  add_laws(chart, set, own, other, {0, 2, 1});
  chart.layers.emplace_back(line_of(own.closing, PathView::opening, "", own_stroke(kBlue)));
  chart.layers.emplace_back(line_of(other.closing, PathView::opening, "", other_stroke(kInk)));
  chart.layers.emplace_back(initial_stiffness(p));
  const PathPoint elastic = at_opening(own.virgin, turning_points(p)[0]);
  const PathPoint turn = at_opening(own.virgin, turning_points(p)[1]);
  const PathPoint& peak = own.limits.strongest;
  chart.layers.emplace_back(
      named_points({{peak.opening, peak.normal_traction},
                    {elastic.opening, elastic.normal_traction},
                    {turn.opening, turn.normal_traction}},
                   {fmt::format("peak: δ_{{ct}} = {} mm, t_{{c}} = {} MPa", short_number(peak.opening),
                                short_number(peak.normal_traction)),
                    "turned in hardening", "δ_{max}, D = " + fmt::format("{:.2f}", turn.damage)}));
  chart.x_range = render::Range{-kClosingShown * p.delta_ct, kNearPeak * p.delta_ct};
  chart.y_range = render::Range{1.04 * own.closing.back().normal_traction, 1.3 * peak.normal_traction};
  return chart;
}

}  // namespace

LawFigure tension_figure(const LawSet& set) {
  const Tension own = drive_tension(set.own.law), other = drive_tension(set.other.law);
  LawFigure result{"tension", {}, {}};
  result.figure.title = "Contact law in tension: " + set.title;
  result.figure.caption =
      set.parameters +
      " Arrows: unloading and reloading. The literal law is elastic up to its peak; the default law "
      "goes back along the secant.";
  result.figure.charts = {whole_curve(set, own, other), near_peak(set, own, other)};
  result.figure.columns = 2;
  result.figure.letters = render::Letters::each;
  result.figure.width = 2000;
  result.figure.height = 1050;
  for (const auto& [law, paths] : {std::pair{&set.own, &own}, std::pair{&set.other, &other}}) {
    add_rows(result.rows, *law, "opening", paths->virgin);
    add_rows(result.rows, *law, "opening with unloading", paths->looped);
    add_rows(result.rows, *law, "closing", paths->closing);
  }
  return result;
}

}  // namespace asperity::app
