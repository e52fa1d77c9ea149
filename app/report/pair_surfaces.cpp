#include "app/report/pair_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/report/report_parts.hpp"

namespace asperity::app {
namespace {

constexpr int kGridPoints = 61, kLimitPoints = 181;

render::Range range_of_factor(const CalibrationData& data, std::size_t k) {
  return {data.factors[k].real(-data.reach), data.factors[k].real(data.reach)};
}

Vec2 real_point(const CalibrationData& data, Pair pair, double x, double y) {
  return {data.factors[pair.i].real(x), data.factors[pair.j].real(y)};
}

/// Points of the design in the plane of the two factors, each place once.
std::vector<render::DesignPoint> points_of(const CalibrationData& data, Pair pair) {
  std::vector<render::DesignPoint> points;
  for (std::size_t r = 0; r < std::min(data.coded.size(), data.kinds.size()); ++r) {
    const double x = data.coded[r][pair.i], y = data.coded[r][pair.j];
    const Vec2 at = real_point(data, pair, x, y);
    const bool known = std::any_of(points.begin(), points.end(), [&](const auto& p) { return p.at == at; });
    // A star point on the third axis lies over the centre, and the centre is what one looks for there.
    const bool hidden = data.kinds[r] == render::DesignPointKind::star && x == 0 && y == 0;
    if (!known && !hidden) points.push_back({at, data.kinds[r]});
  }
  return points;
}

/// Where the plane cuts the sphere through the outermost runs; empty where it misses it.
std::vector<Vec2> limit_of(const CalibrationData& data, Pair pair) {
  double square = data.radius * data.radius;
  const std::vector<double> held = data.held();
  for (std::size_t k = 0; k < held.size(); ++k)
    if (k != pair.i && k != pair.j) square -= held[k] * held[k];
  std::vector<Vec2> line;
  for (int i = 0; square > 0 && i < kLimitPoints; ++i) {
    const double angle = 2 * std::numbers::pi * i / (kLimitPoints - 1), radius = std::sqrt(square);
    line.push_back(real_point(data, pair, radius * std::cos(angle), radius * std::sin(angle)));
  }
  return line;
}

/// Size and columns of a figure with one chart a pair.
void lay_out_pairs(render::ChartFigure& figure, std::size_t pairs) {
  figure.columns = static_cast<int>(std::min<std::size_t>(3, pairs));
  const int rows = static_cast<int>((pairs + 2) / 3);
  figure.height = 330 + (pairs == 1 ? 850 : pairs == 2 ? 620 : 480) * rows;
  figure.letters = pairs > 1 ? render::Letters::each : render::Letters::none;
  figure.colour_bars = render::ColourBars::shared;
}

render::SurfacePlot surface_of_pair(const CalibrationData& data, Pair pair, const LevelFunction& value,
                                    const render::SurfacePlot& common) {
  render::SurfacePlot plot = plot_of_pair(data, pair);
  const std::string held = held_text(data, pair.i, pair.j);
  plot.grid = over_pair(data, pair, value);
  plot.heading = held.empty() ? "" : "held: " + held;
  plot.value_label = common.value_label;
  plot.map = common.map;
  plot.level_names = common.level_names;
  for (render::TargetLine target : common.targets) {
    target.grid = plot.grid;
    plot.targets.push_back(target);
  }
  return plot;
}

}  // namespace

std::vector<Pair> pairs_of(const CalibrationData& data) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < data.factors.size(); ++i)
    for (std::size_t j = i + 1; j < data.factors.size(); ++j) pairs.push_back({i, j});
  return pairs;
}

render::ScalarGrid over_pair(const CalibrationData& data, Pair pair, const LevelFunction& value) {
  std::vector<double> levels = data.held();
  return render::sample_grid(range_of_factor(data, pair.i), range_of_factor(data, pair.j), kGridPoints,
                             [&](double x, double y) {
                               levels[pair.i] = data.factors[pair.i].coded(x);
                               levels[pair.j] = data.factors[pair.j].coded(y);
                               return value(levels);
                             });
}

render::SurfacePlot plot_of_pair(const CalibrationData& data, Pair pair) {
  render::SurfacePlot plot;
  plot.x_label = short_axis_label(data.factors[pair.i].quantity);
  plot.y_label = short_axis_label(data.factors[pair.j].quantity);
  plot.points = points_of(data, pair);
  plot.limit = limit_of(data, pair);
  if (data.solution.empty()) return plot;
  plot.solution = real_point(data, pair, data.solution[pair.i], data.solution[pair.j]);
  if (!data.region.empty() && data.region[pair.i] && data.region[pair.j])
    plot.region = render::FactorBox{*data.region[pair.i], *data.region[pair.j]};
  return plot;
}

render::ChartFigure pair_figure(const CalibrationData& data, const LevelFunction& value,
                                const render::SurfacePlot& common) {
  render::ChartFigure figure;
  std::vector<render::SurfacePlot> plots;
  std::vector<double> all;
  for (const Pair pair : pairs_of(data)) {
    plots.push_back(surface_of_pair(data, pair, value, common));
    all.insert(all.end(), plots.back().grid.values.begin(), plots.back().grid.values.end());
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

std::string where_held(const CalibrationData& data) {
  if (data.factors.size() < 3) return "";
  return data.solution.empty() ? "Other factors at the design's centre." : "Other factors at the solution.";
}

}  // namespace asperity::app
