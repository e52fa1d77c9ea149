#include "render/surface_plots.hpp"

#include "render/style.hpp"

namespace asperity::render {
namespace {

constexpr double kTargetWidth = 5, kRegionWidth = 3.5, kPointRadius = 8, kSolutionRadius = 12;  // pixels
constexpr double kLimitWidth = 2.4, kLimitCasing = 0.3;                                         // pixels

/// Dash patterns of target lines where there are several.
const std::vector<double>& target_dash(std::size_t number) { return style::kDashes[number % style::kDashes.size()]; }

Stroke target_stroke(const SurfacePlot& plot, std::size_t number) {
  if (plot.targets.size() == 1) return {style::kVermilion, kTargetWidth, {}, Cap::butt};
  const Colour colour = style::kLines[number % style::kLines.size()];
  return {colour, kTargetWidth, target_dash(number), Cap::butt};
}

Marker marker_of(DesignPointKind kind) {
  switch (kind) {
    case DesignPointKind::factorial:
      return {MarkerShape::open_square, style::kInk, kPointRadius};
    case DesignPointKind::star:
      return {MarkerShape::open_diamond, style::kInk, kPointRadius};
    case DesignPointKind::centre:
      return {MarkerShape::ring, style::kInk, kPointRadius};
  }
  return {};
}

PointLayer points_of(const SurfacePlot& plot, DesignPointKind kind, const char* label) {
  PointLayer layer{label, {}, {}, marker_of(kind), {}, {}, {}};
  for (const DesignPoint& point : plot.points) {
    if (point.kind != kind) continue;
    layer.x.push_back(point.at.x);
    layer.y.push_back(point.at.y);
  }
  return layer;
}

void add_design(Chart& chart, const SurfacePlot& plot) {
  for (const PointLayer& layer : {points_of(plot, DesignPointKind::factorial, "factorial points"),
                                  points_of(plot, DesignPointKind::star, "star points"),
                                  points_of(plot, DesignPointKind::centre, "centre points")})
    if (!layer.x.empty()) chart.layers.emplace_back(layer);
}

/// A white line under the dashes keeps the rectangle visible on dark colours.
void add_region(Chart& chart, const FactorBox& region) {
  const Stroke under{style::kPaper, kRegionWidth + 3, {}, Cap::butt};
  const Stroke over{style::kInk, kRegionWidth, {14, 8}, Cap::butt};
  chart.layers.emplace_back(BoxLayer{"", region.x, region.y, std::nullopt, under});
  chart.layers.emplace_back(BoxLayer{"95 % region", region.x, region.y, std::nullopt, over});
}

void add_limit(Chart& chart, const std::vector<Vec2>& limit) {
  LineLayer line{"limit of the design", {}, {}, {style::kInk, kLimitWidth, {6, 6}, Cap::butt}, kLimitCasing};
  for (const Vec2 p : limit) {
    line.x.push_back(p.x);
    line.y.push_back(p.y);
  }
  chart.layers.emplace_back(std::move(line));
}

}  // namespace

Chart surface_chart(const SurfacePlot& plot) {
  Chart chart{plot.heading, plot.x_label, plot.y_label, {}, range_of(plot.grid.x), range_of(plot.grid.y), {}};
  const auto levels = plot.levels.empty() ? round_levels(plot.grid.values, 10) : plot.levels;
  chart.layers.emplace_back(FieldLayer{plot.grid, levels, plot.value_label, plot.map, plot.level_names});
  for (std::size_t i = 0; i < plot.targets.size(); ++i) {
    const TargetLine& target = plot.targets[i];
    const std::string label = plot.targets.size() == 1 ? "target" : "target of " + target.name;
    chart.layers.emplace_back(ContourLayer{label, target.grid, target.value, target_stroke(plot, i), target.name});
  }
  if (!plot.limit.empty()) add_limit(chart, plot.limit);
  add_design(chart, plot);
  if (plot.region) add_region(chart, *plot.region);
  if (plot.solution)
    chart.layers.emplace_back(PointLayer{"solution",
                                         {plot.solution->x},
                                         {plot.solution->y},
                                         {MarkerShape::star, style::kVermilion, kSolutionRadius},
                                         {},
                                         {},
                                         {}});
  return chart;
}

}  // namespace asperity::render
