#include "render/outcome_plots.hpp"

#include <fmt/format.h>

#include <cmath>

#include "render/style.hpp"

namespace asperity::render {
namespace {

// Parts of a category's width: half a bar and half a tolerance band; where prediction, mean and meshes stand in it.
constexpr double kBarHalf = 0.30, kBandHalf = 0.42, kPredictedAt = -0.36, kMeanAt = -0.14, kMeshesFrom = 0.02,
                 kMeshesTo = 0.25;
constexpr double kMeshRadius = 6, kMeanRadius = 10, kPredictedRadius = 10;  // pixels
constexpr Colour kTolerance{0xD9, 0xEF, 0xE6}, kTargetFill{0xD9, 0xEF, 0xE6}, kInside{0x9F, 0xC8, 0xE2},
    kOutside{0xF2, 0xB4, 0x8B};
constexpr double kPercent = 100;

double deviation(const VerifiedProperty& p, double value) { return kPercent * (value / p.target - 1); }

bool within(const VerifiedProperty& p) { return std::abs(p.mean / p.target - 1) <= p.tolerance; }

std::string signed_percent(double value) { return fmt::format("{}{:.1f}", value < 0 ? "−" : "+", std::abs(value)); }

/// Name, and under it the deviation with its scatter: beside the points it would lie over one of them sooner or later.
std::string category(const VerifiedProperty& p) {
  return p.name + "\n" + signed_percent(deviation(p, p.mean)) +
         fmt::format(" ± {:.1f} %", kPercent * p.sd / std::abs(p.target));
}

BoxLayer tolerance_box(const VerifiedProperty& p, double place) {
  const double limit = kPercent * p.tolerance;
  return {"tolerance",
          {place - kBandHalf, place + kBandHalf},
          {-limit, limit},
          kTolerance,
          Stroke{style::kGreen, 2, {8, 6}, Cap::butt}};
}

BoxLayer bar(const VerifiedProperty& p, double place) {
  const double end = deviation(p, p.mean);
  const Stroke edge{within(p) ? style::kBlue : style::kVermilion, 2.5, {}, Cap::butt};
  return {within(p) ? "mean within tolerance" : "mean outside tolerance",
          {place - kBarHalf, place + kBarHalf},
          {std::min(0.0, end), std::max(0.0, end)},
          within(p) ? kInside : kOutside,
          edge};
}

/// Values side by side in the right half of the bar, in their order.
std::vector<double> spread(double place, std::size_t count) {
  std::vector<double> places;
  for (std::size_t i = 0; i < count; ++i) {
    const double part = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0.5;
    places.push_back(place + kMeshesFrom + part * (kMeshesTo - kMeshesFrom));
  }
  return places;
}

/// The points of all properties in four layers: predictions, single meshes, means.
struct Points {
  PointLayer predicted{
      "predicted by the models", {}, {}, {MarkerShape::open_diamond, style::kInk, kPredictedRadius}, {}, {}, {}};
  PointLayer meshes{"single meshes", {}, {}, {MarkerShape::disc, style::kSoftInk, kMeshRadius}, {}, {}, {}};
  PointLayer means{"mean ± standard deviation", {}, {}, {MarkerShape::square, style::kInk, kMeanRadius}, {}, {}, {}};
};

void add_points(Points& points, const VerifiedProperty& p, double place) {
  if (p.predicted && std::isfinite(*p.predicted)) {
    points.predicted.x.push_back(place + kPredictedAt);
    points.predicted.y.push_back(deviation(p, *p.predicted));
  }
  const std::vector<double> places = spread(place, p.values.size());
  for (std::size_t i = 0; i < p.values.size(); ++i) {
    points.meshes.x.push_back(places[i]);
    points.meshes.y.push_back(deviation(p, p.values[i]));
  }
  points.means.x.push_back(place + kMeanAt);
  points.means.y.push_back(deviation(p, p.mean));
  points.means.y_error.push_back(kPercent * p.sd / std::abs(p.target));
}

/// All meshes of all sets are one layer, so that the legend names them once.
PointLayer meshes_of(const std::vector<VerifiedSet>& sets) {
  PointLayer layer{"single meshes", {}, {}, {MarkerShape::disc, {0x9A, 0x9A, 0x9A}, kMeshRadius}, {}, {}, {}};
  for (const VerifiedSet& set : sets)
    for (std::size_t i = 0; i < std::min(set.x_values.size(), set.y_values.size()); ++i) {
      layer.x.push_back(set.x_values[i]);
      layer.y.push_back(set.y_values[i]);
    }
  return layer;
}

PointLayer mean_of(const VerifiedSet& set, std::size_t number) {
  using enum MarkerShape;
  static constexpr std::array<MarkerShape, 7> shapes{star, disc, square, diamond, triangle, ring, open_square};
  const Marker marker{shapes[number % shapes.size()], style::kLines[number % style::kLines.size()], kMeanRadius};
  const std::string letter(1, static_cast<char>('A' + number % 26));
  return {letter + "  " + set.name, {set.x}, {set.y}, marker, {set.x_sd}, {set.y_sd}, {letter}};
}

}  // namespace

ChartFigure verification_bars(const std::string& title, const std::vector<VerifiedProperty>& properties) {
  Chart chart;
  chart.y_label = "deviation from target [%]";
  Points points;
  double place = 0;
  for (const VerifiedProperty& p : properties) {
    chart.x_categories.push_back(category(p));
    chart.layers.emplace_back(tolerance_box(p, ++place));
    chart.layers.emplace_back(bar(p, place));
    add_points(points, p, place);
  }
  chart.layers.emplace_back(LineLayer{"target", {0.4, place + 0.6}, {0, 0}, {style::kInk, 3, {}, Cap::butt}});
  for (const PointLayer& layer : {points.predicted, points.means, points.meshes})
    if (!layer.x.empty()) chart.layers.emplace_back(layer);
  ChartFigure figure;
  figure.title = title;
  figure.charts = {chart};
  figure.height = 1150;
  return figure;
}

ChartFigure trade_off(const TradeOff& given) {
  Chart chart;
  chart.x_label = given.x_label;
  chart.y_label = given.y_label;
  chart.layers.emplace_back(BoxLayer{"both targets met", given.x_target, given.y_target, kTargetFill,
                                     Stroke{style::kGreen, 3, {10, 6}, Cap::butt}});
  const PointLayer meshes = meshes_of(given.sets);
  if (!meshes.x.empty()) chart.layers.emplace_back(meshes);
  for (std::size_t i = 0; i < given.sets.size(); ++i) chart.layers.emplace_back(mean_of(given.sets[i], i));
  ChartFigure figure;
  figure.title = given.title;
  figure.caption = given.caption;
  figure.charts = {chart};
  figure.height = 1150;
  return figure;
}

}  // namespace asperity::render
