#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/report_parts.hpp"
#include "render/style.hpp"

namespace asperity::app {
namespace {

constexpr int kGridPoints = 61;
constexpr const char* kOverall = "overall desirability D [–]";

struct Pair {
  std::size_t i = 0, j = 1;
};

std::vector<Pair> pairs_of(const CalibrationData& data) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < data.factors.size(); ++i)
    for (std::size_t j = i + 1; j < data.factors.size(); ++j) pairs.push_back({i, j});
  return pairs;
}

render::Range range_of_factor(const CalibrationData& data, std::size_t k) {
  return {data.factors[k].real(-data.reach), data.factors[k].real(data.reach)};
}

/// A quantity over two factors in real units, the others held.
template <class Function>
render::ScalarGrid over_pair(const CalibrationData& data, Pair pair, const Function& value) {
  std::vector<double> levels = data.held();
  return render::sample_grid(range_of_factor(data, pair.i), range_of_factor(data, pair.j), kGridPoints,
                             [&](double x, double y) {
                               levels[pair.i] = data.factors[pair.i].coded(x);
                               levels[pair.j] = data.factors[pair.j].coded(y);
                               return value(levels);
                             });
}

/// Points of the design in the plane of the two factors, each place once.
std::vector<render::DesignPoint> points_of(const CalibrationData& data, Pair pair) {
  std::vector<render::DesignPoint> points;
  for (std::size_t r = 0; r < std::min(data.coded.size(), data.kinds.size()); ++r) {
    const Vec2 at{data.factors[pair.i].real(data.coded[r][pair.i]), data.factors[pair.j].real(data.coded[r][pair.j])};
    const bool known = std::any_of(points.begin(), points.end(), [&](const auto& p) { return p.at == at; });
    // A star point on the third axis lies over the centre, and the centre is what one looks for there.
    const bool hidden =
        data.kinds[r] == render::DesignPointKind::star && data.coded[r][pair.i] == 0 && data.coded[r][pair.j] == 0;
    if (!known && !hidden) points.push_back({at, data.kinds[r]});
  }
  return points;
}

render::SurfacePlot plot_of_pair(const CalibrationData& data, Pair pair) {
  render::SurfacePlot plot;
  plot.x_label = short_axis_label(data.factors[pair.i].quantity);
  plot.y_label = short_axis_label(data.factors[pair.j].quantity);
  plot.points = points_of(data, pair);
  if (data.solution.empty()) return plot;
  plot.solution =
      Vec2{data.factors[pair.i].real(data.solution[pair.i]), data.factors[pair.j].real(data.solution[pair.j])};
  if (!data.region.empty() && data.region[pair.i] && data.region[pair.j])
    plot.region = render::FactorBox{*data.region[pair.i], *data.region[pair.j]};
  return plot;
}

/// Size and columns of a figure with one chart a pair.
void lay_out_pairs(render::ChartFigure& figure, std::size_t pairs) {
  figure.columns = static_cast<int>(std::min<std::size_t>(3, pairs));
  const int rows = static_cast<int>((pairs + 2) / 3);
  figure.height = 290 + (pairs == 1 ? 850 : pairs == 2 ? 620 : 480) * rows;
  figure.letters = pairs > 1 ? render::Letters::each : render::Letters::none;
  figure.colour_bars = render::ColourBars::shared;
}

std::string held_sentence(const CalibrationData& data, Pair pair) {
  const std::string held = held_text(data, pair.i, pair.j);
  return held.empty() ? "" : "held: " + held;
}

std::string where_held(const CalibrationData& data) {
  if (data.factors.size() < 3) return "";
  return data.solution.empty() ? "Other factors at the design's centre." : "Other factors at the solution.";
}

/// Surfaces of one quantity over all pairs of factors with the same levels.
template <class Function>
render::ChartFigure pair_figure(const CalibrationData& data, const Function& value, render::SurfacePlot common) {
  render::ChartFigure figure;
  std::vector<render::SurfacePlot> plots;
  std::vector<double> all;
  for (const Pair pair : pairs_of(data)) {
    render::SurfacePlot plot = plot_of_pair(data, pair);
    plot.grid = over_pair(data, pair, value);
    plot.heading = held_sentence(data, pair);
    plot.value_label = common.value_label;
    plot.map = common.map;
    for (render::TargetLine target : common.targets) {
      target.grid = plot.grid;
      plot.targets.push_back(target);
    }
    all.insert(all.end(), plot.grid.values.begin(), plot.grid.values.end());
    plots.push_back(std::move(plot));
  }
  const std::vector<double> levels = common.levels.empty() ? render::round_levels(all, 10) : common.levels;
  for (render::SurfacePlot& plot : plots) {
    plot.levels = levels;
    figure.charts.push_back(render::surface_chart(plot));
  }
  lay_out_pairs(figure, plots.size());
  figure.caption = where_held(data);
  return figure;
}

html::Markup surface_figure(const ReportContext& context, const ModelData& model) {
  const Quantity quantity = quantity_of(model.property);
  const auto target = context.data.targets.find(model.property);
  render::SurfacePlot common;
  common.value_label = axis_label(quantity);
  std::string aim = "no target";
  if (target != context.data.targets.end()) {
    common.targets = {{{}, target->second.value, fmt::format("target {:.4g}", target->second.value)}};
    aim = fmt::format("the target {:.4g} {} is a thick line where it is reached", target->second.value, quantity.unit);
  }
  render::ChartFigure figure = pair_figure(
      context.data, [&](const std::vector<double>& x) { return model.surface.value(x); }, common);
  figure.title = "Response surface: " + quantity.name;
  const PlotText text{"response_surface_" + model.property,
                      fmt::format("Contours of the fitted {} over each pair of factors; {}.", quantity.name, aim),
                      html::Markup(capitalised(quantity.name) + " by the reduced model over each pair of factors. ") +
                          html::Markup(where_held(context.data))};
  return plot_figure(context, text, figure);
}

std::vector<double> desirability_levels() { return {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9}; }

double spread(const render::ScalarGrid& grid) {
  const render::Range range = render::range_of(grid.values);
  return range.high - range.low;
}

/// The two factors over which the desirability changes most.
Pair most_telling_pair(const CalibrationData& data) {
  const auto desirable = [&](const std::vector<double>& x) { return data.overall_desirability(x); };
  const std::vector<Pair> pairs = pairs_of(data);
  return *std::max_element(pairs.begin(), pairs.end(), [&](Pair a, Pair b) {
    return spread(over_pair(data, a, desirable)) < spread(over_pair(data, b, desirable));
  });
}

/// The desirability over one pair with the line of each target on it: where the lines meet, the targets do.
render::ChartFigure target_map(const CalibrationData& data, Pair pair) {
  render::SurfacePlot plot = plot_of_pair(data, pair);
  plot.x_label = axis_label(data.factors[pair.i].quantity);
  plot.y_label = axis_label(data.factors[pair.j].quantity);
  plot.grid = over_pair(data, pair, [&](const std::vector<double>& x) { return data.overall_desirability(x); });
  plot.levels = desirability_levels();
  plot.value_label = kOverall;
  plot.map = render::ColourMap::grey;
  plot.points.clear();
  for (const ModelData& model : data.models) {
    const auto target = data.targets.find(model.property);
    if (target == data.targets.end()) continue;
    plot.targets.push_back({over_pair(data, pair, [&](const std::vector<double>& x) { return model.surface.value(x); }),
                            target->second.value, picture_symbol(quantity_of(model.property))});
  }
  render::ChartFigure figure;
  figure.title = "Where the targets are met";
  const std::string held = held_text(data, pair.i, pair.j);
  figure.caption = held.empty() ? "" : "Held: " + held + ". A target without a line is not reached in this plane.";
  figure.charts = {render::surface_chart(plot)};
  return figure;
}

}  // namespace

html::Section surfaces_section(const ReportContext& context) {
  html::Section section{"Response surfaces", {}, {}};
  if (context.data.factors.size() < 2) return section;
  for (const ModelData& model : context.data.models)
    if (context.data.targets.contains(model.property) || context.data.targets.empty())
      section.parts.push_back(surface_figure(context, model));
  if (!section.parts.empty())
    section.parts.insert(
        section.parts.begin(),
        html::paragraph("Each surface is the model after elimination, evaluated over two factors. Squares, "
                        "diamonds and rings are the design's points as seen along the other factors; the "
                        "dashed rectangle is the 95 % region of the solution, the star the solution itself."));
  return section;
}

std::vector<html::Markup> desirability_figures(const ReportContext& context) {
  const CalibrationData& data = context.data;
  if (data.factors.size() < 2 || !std::isfinite(data.overall_desirability(data.held()))) return {};
  render::SurfacePlot common;
  common.value_label = kOverall;
  common.levels = desirability_levels();
  common.map = render::ColourMap::viridis;
  render::ChartFigure map = pair_figure(
      data, [&](const std::vector<double>& x) { return data.overall_desirability(x); }, common);
  map.title = "Desirability";
  const PlotText map_text{
      "desirability_map",
      fmt::format("Contours of the overall desirability over each pair of factors, from 0 to 1; at the "
                  "solution it is {:.2f}.",
                  data.overall_desirability(data.held())),
      "Overall desirability of all targets over each pair of factors, by the reduced models. " + where_held(data)};
  const Pair pair = most_telling_pair(data);
  const PlotText lines_text{
      "targets_map",
      "Lines along which each target is met by its model, over the two factors that matter most, on "
      "the overall desirability in grey.",
      "Lines along which each property meets its target, over the two factors that change the "
      "desirability most. They cross in one point where all targets can be met together."};
  return {plot_figure(context, map_text, map), plot_figure(context, lines_text, target_map(data, pair))};
}

}  // namespace asperity::app
