#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/pair_surfaces.hpp"
#include "app/report/report_parts.hpp"

namespace asperity::app {
namespace {

constexpr const char* kOverall = "overall desirability D [–]";

/// Where the model reaches the target within the design's reach, over any pair of factors.
bool is_reached(const CalibrationData& data, const ModelData& model, double target) {
  const std::vector<Pair> pairs = pairs_of(data);
  return std::any_of(pairs.begin(), pairs.end(), [&](Pair pair) {
    const auto grid = over_pair(data, pair, [&](const std::vector<double>& x) { return model.surface.value(x); });
    const render::Range range = render::range_of(grid.values);
    return range.low <= target && target <= range.high;
  });
}

html::Markup surface_figure(const ReportContext& context, const ModelData& model) {
  const CalibrationData& data = context.data;
  const Quantity quantity = quantity_of(model.property);
  const auto found = data.targets.find(model.property);
  render::SurfacePlot common;
  common.value_label = axis_label(quantity);
  std::string aim = "No target is given.";
  if (found != data.targets.end()) {
    const double target = found->second.value;
    common.targets = {{{}, target, fmt::format("{:.4g}", target)}};
    aim = fmt::format("The target {:.4g}{}{} {}.", target, quantity.unit == "–" ? "" : " ",
                      quantity.unit == "–" ? "" : quantity.unit,
                      is_reached(data, model, target) ? "is the thick line" : "is not reached in any of these planes");
  }
  render::ChartFigure figure = pair_figure(
      data, [&](const std::vector<double>& x) { return model.surface.value(x); }, common);
  figure.title = "Response surface: " + quantity.name;
  figure.caption += " " + aim;
  const PlotText text{
      "response_surface_" + model.property,
      "Contours of the fitted " + quantity.name + " over each pair of factors. " + aim,
      capitalised(quantity.name) + " by the reduced model over each pair of factors. " + where_held(data) + " " + aim};
  return plot_figure(context, text, figure);
}

double spread(const render::ScalarGrid& grid) {
  const render::Range range = render::range_of(grid.values);
  return range.high - range.low;
}

/// Root mean square of the relative misses of all targets by the models, %.
double mean_miss(const CalibrationData& data, const std::vector<double>& levels) {
  double sum = 0;
  int count = 0;
  for (const ModelData& model : data.models) {
    const auto target = data.targets.find(model.property);
    if (target == data.targets.end()) continue;
    const double miss = model.surface.value(levels) / target->second.value - 1;
    sum += miss * miss;
    ++count;
  }
  return 100 * std::sqrt(sum / count);
}

/// The two factors over which the misses change most.
Pair most_telling_pair(const CalibrationData& data) {
  const auto miss = [&](const std::vector<double>& x) { return mean_miss(data, x); };
  const std::vector<Pair> pairs = pairs_of(data);
  return *std::max_element(pairs.begin(), pairs.end(), [&](Pair a, Pair b) {
    return spread(over_pair(data, a, miss)) < spread(over_pair(data, b, miss));
  });
}

/// The misses over one pair with the line of each target on it: where the lines meet, the targets do.
render::ChartFigure target_map(const CalibrationData& data, Pair pair) {
  render::SurfacePlot plot = plot_of_pair(data, pair);
  plot.x_label = axis_label(data.factors[pair.i].quantity);
  plot.y_label = axis_label(data.factors[pair.j].quantity);
  plot.grid = over_pair(data, pair, [&](const std::vector<double>& x) { return mean_miss(data, x); });
  plot.levels = {5, 10, 15, 20, 30, 40, 50, 75, 100, 150};
  plot.value_label = "root mean square miss of all targets [%]";
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
  figure.caption = (held.empty() ? "" : "Held: " + held + ". ") +
                   std::string("A target without a line is not reached in this plane.");
  figure.charts = {render::surface_chart(plot)};
  return figure;
}

html::Markup target_figure(const ReportContext& context) {
  const PlotText text{
      "targets_map",
      "Lines along which each target is met by its model, over the two factors that matter most, on the "
      "root mean square miss of all targets in grey.",
      "Lines along which each property meets its target by the reduced models, over the two factors that "
      "change the misses most. They cross in one point where all targets can be met together."};
  return plot_figure(context, text, target_map(context.data, most_telling_pair(context.data)));
}

/// Whether any plane through the solution has a desirability that a map would show.
bool is_desirable_somewhere(const CalibrationData& data) {
  const std::vector<Pair> pairs = pairs_of(data);
  return std::any_of(pairs.begin(), pairs.end(), [&](Pair pair) {
    return spread(over_pair(data, pair, [&](const std::vector<double>& x) { return data.overall_desirability(x); })) >
           0;
  });
}

html::Markup desirability_figure(const ReportContext& context) {
  const CalibrationData& data = context.data;
  render::SurfacePlot common;
  common.value_label = kOverall;
  common.map = render::ColourMap::viridis;
  for (int tenths = 1; tenths < 10; ++tenths) {
    common.levels.push_back(std::pow(tenths / 10.0, data.total_weight()));
    common.level_names.push_back(fmt::format("{:.1f}", tenths / 10.0));
  }
  render::ChartFigure figure = pair_figure(
      data, [&](const std::vector<double>& x) { return data.desirability_product(x); }, common);
  figure.title = "Desirability";
  const PlotText text{
      "desirability_map",
      fmt::format("Contours of the overall desirability over each pair of factors, from 0 to 1; at the point where the "
                  "planes meet it is {:.2f}.",
                  data.overall_desirability(data.held())),
      "Overall desirability of all targets over each pair of factors, by the reduced models. " + where_held(data)};
  return plot_figure(context, text, figure);
}

}  // namespace

html::Section surfaces_section(const ReportContext& context) {
  html::Section section{"Response surfaces", {}, {}};
  if (context.data.factors.size() < 2) return section;
  for (const ModelData& model : context.data.models)
    if (context.data.targets.contains(model.property) || context.data.targets.empty())
      section.parts.push_back(surface_figure(context, model));
  if (section.parts.empty()) return section;
  section.parts.insert(
      section.parts.begin(),
      html::paragraph("Each surface is the model after elimination, evaluated over two factors. Squares, diamonds "
                      "and rings are the design's points as seen along the other factors, dots the limit of the "
                      "design: the sphere through its outermost runs, beyond which the model extrapolates. The "
                      "dashed rectangle is the 95 % region of the solution, the star the solution itself."));
  return section;
}

std::vector<html::Markup> desirability_figures(const ReportContext& context) {
  const CalibrationData& data = context.data;
  if (data.factors.size() < 2 || !std::isfinite(data.overall_desirability(data.held()))) return {};
  if (is_desirable_somewhere(data)) return {desirability_figure(context), target_figure(context)};
  return {html::notice(
              html::NoticeKind::information,
              fmt::format("The overall desirability is 0 everywhere in the planes through the {}: nowhere are all "
                          "models within {:.0f} % of their targets. So there is no map of it.",
                          data.solution.empty() ? "design's centre" : "solution", 100 * data.desirability.half_range)),
          target_figure(context)};
}

}  // namespace asperity::app
