#include "render/chart_layers.hpp"

#include <algorithm>
#include <cmath>

#include "render/style.hpp"
#include "render/text_metrics.hpp"

namespace asperity::render {
namespace {

constexpr double kWhisker = 9;                             // half the end of an error bar, pixels
constexpr double kErrorWidth = 3;                          // pixels
constexpr double kArrowWay = 12;                           // of a line, over which its direction is taken, pixels
constexpr double kArrowLength = 5, kArrowHalfWidth = 2.4;  // of the line's width

/// Keeps the part of [t0, t1] where p + t q >= 0; false if none is left.
bool keep_positive(double p, double q, double& t0, double& t1) {
  if (q == 0) return p >= 0;
  const double t = -p / q;
  (q > 0 ? t0 = std::max(t0, t) : t1 = std::min(t1, t));
  return t0 <= t1;
}

/// Liang and Barsky's cut of one segment.
bool cut(Vec2& a, Vec2& b, const Box& box) {
  double t0 = 0, t1 = 1;
  const Vec2 d = b - a;
  const bool inside = keep_positive(a.x - box.left, d.x, t0, t1) && keep_positive(box.right - a.x, -d.x, t0, t1) &&
                      keep_positive(a.y - box.top, d.y, t0, t1) && keep_positive(box.bottom - a.y, -d.y, t0, t1);
  if (!inside) return false;
  const Vec2 start = a;
  a = start + t0 * d;
  b = start + t1 * d;
  return true;
}

/// The way a line comes to its point `at` from the last point that is far enough away; none at its beginning.
Vec2 direction_at(const PlotArea& area, const LineLayer& layer, std::size_t at) {
  const Vec2 tip = area.place(layer.x[at], layer.y[at]);
  for (std::size_t i = at; i-- > 0;) {
    const Vec2 way = tip - area.place(layer.x[i], layer.y[i]);
    if (norm(way) >= kArrowWay) return (1.0 / norm(way)) * way;
  }
  return {};
}

void draw_arrows(Drawing& drawing, const PlotArea& area, const LineLayer& layer) {
  for (const std::size_t at : layer.arrows) {
    const Vec2 tip = area.place(layer.x[at], layer.y[at]), way = direction_at(area, layer, at);
    if (!near_box(tip, area.box)) continue;
    const Vec2 back = tip - (kArrowLength * layer.stroke.width) * way;
    const Vec2 across = (kArrowHalfWidth * layer.stroke.width) * Vec2{-way.y, way.x};
    drawing.shapes.push_back(Triangle{{tip, back + across, back - across}, layer.stroke.colour});
  }
}

void draw_line_layer(Drawing& drawing, const PlotArea& area, const LineLayer& layer) {
  const Stroke casing{style::kPaper, layer.stroke.width + 2 * layer.casing, {}, layer.stroke.cap};
  for (const auto& run : finite_runs(area, layer.x, layer.y))
    for (const auto& part : clipped(run, area.box)) {
      if (layer.casing > 0) drawing.shapes.push_back(Polyline{part, casing});
      drawing.shapes.push_back(Polyline{part, layer.stroke});
    }
  draw_arrows(drawing, area, layer);
}

void draw_band_layer(Drawing& drawing, const PlotArea& area, const BandLayer& layer) {
  Band band{{}, {}, layer.fill};
  const auto inside = [&](double x, double y) {
    const Vec2 p = area.place(x, y);
    return Vec2{p.x, std::clamp(p.y, area.box.top, area.box.bottom)};
  };
  for (std::size_t i = 0; i < std::min({layer.x.size(), layer.lower.size(), layer.upper.size()}); ++i) {
    if (!std::isfinite(layer.lower[i]) || !std::isfinite(layer.upper[i])) continue;
    if (layer.x[i] < area.x.range.low || layer.x[i] > area.x.range.high) continue;
    band.lower.push_back(inside(layer.x[i], layer.lower[i]));
    band.upper.push_back(inside(layer.x[i], layer.upper[i]));
  }
  if (band.lower.size() > 1) drawing.shapes.push_back(band);
}

/// An error bar from `centre` to `arm` at both sides, with whiskers across its ends that lie in the frame.
void draw_error_bar(Drawing& drawing, const PlotArea& area, Vec2 centre, Vec2 arm, Colour colour) {
  const Stroke stroke{colour, kErrorWidth, {}, Cap::butt};
  for (const auto& part : clipped({centre - arm, centre + arm}, area.box))
    drawing.shapes.push_back(Polyline{part, stroke});
  if (norm(arm) == 0) return;
  const Vec2 across = (kWhisker / norm(arm)) * Vec2{-arm.y, arm.x};
  for (const Vec2 end : {centre - arm, centre + arm})
    if (near_box(end, area.box)) add_line(drawing, end - across, end + across, stroke);
}

void draw_errors(Drawing& drawing, const PlotArea& area, const PointLayer& layer, std::size_t i, Vec2 at) {
  for (const Vec2 arm : error_arms(area, layer, i)) draw_error_bar(drawing, area, at, arm, layer.marker.colour);
}

void draw_point_layer(Drawing& drawing, const PlotArea& area, const PointLayer& layer) {
  for (std::size_t i = 0; i < std::min(layer.x.size(), layer.y.size()); ++i) {
    if (!std::isfinite(layer.x[i]) || !std::isfinite(layer.y[i])) continue;
    const Vec2 at = area.place(layer.x[i], layer.y[i]);
    if (!near_box(at, area.box)) continue;
    draw_errors(drawing, area, layer, i, at);
    add_marker(drawing, at, layer.marker);
  }
}

void draw_box_layer(Drawing& drawing, const PlotArea& area, const BoxLayer& layer) {
  const Vec2 a = area.place(layer.x.low, layer.y.high), b = area.place(layer.x.high, layer.y.low);
  const Box& frame = area.box;
  const Box box{std::clamp(a.x, frame.left, frame.right), std::clamp(a.y, frame.top, frame.bottom),
                std::clamp(b.x, frame.left, frame.right), std::clamp(b.y, frame.top, frame.bottom)};
  if (layer.fill) add_box(drawing, box, *layer.fill);
  if (!layer.edge) return;
  const std::vector<Vec2> outline{a, {b.x, a.y}, b, {a.x, b.y}, a};
  for (const auto& part : clipped(outline, frame)) drawing.shapes.push_back(Polyline{part, *layer.edge});
}

struct LayerPainter {
  Drawing& drawing;
  const PlotArea& area;
  Occupied& occupied;
  void operator()(const LineLayer& layer) const { draw_line_layer(drawing, area, layer); }
  void operator()(const BandLayer& layer) const { draw_band_layer(drawing, area, layer); }
  void operator()(const PointLayer& layer) const { draw_point_layer(drawing, area, layer); }
  void operator()(const BoxLayer& layer) const { draw_box_layer(drawing, area, layer); }
  void operator()(const FieldLayer& layer) const { draw_field(drawing, area, layer, occupied); }
  void operator()(const ContourLayer& layer) const { draw_contour(drawing, area, layer); }
};

}  // namespace

std::vector<std::vector<Vec2>> finite_runs(const PlotArea& area, const std::vector<double>& x,
                                           const std::vector<double>& y) {
  std::vector<std::vector<Vec2>> runs(1);
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    if (std::isfinite(x[i]) && std::isfinite(y[i]))
      runs.back().push_back(area.place(x[i], y[i]));
    else if (!runs.back().empty())
      runs.emplace_back();
  }
  return runs;
}

void draw_layer(Drawing& drawing, const PlotArea& area, const Layer& layer, Occupied& occupied) {
  std::visit(LayerPainter{drawing, area, occupied}, layer);
}

std::vector<Vec2> error_arms(const PlotArea& area, const PointLayer& layer, std::size_t i) {
  const double per_x = area.box.width() / (area.x.range.high - area.x.range.low);
  const double per_y = area.box.height() / (area.y.range.high - area.y.range.low);
  std::vector<Vec2> arms;
  if (i < layer.x_error.size() && std::isfinite(layer.x_error[i])) arms.push_back({layer.x_error[i] * per_x, 0});
  if (i < layer.y_error.size() && std::isfinite(layer.y_error[i])) arms.push_back({0, layer.y_error[i] * per_y});
  return arms;
}

bool near_box(Vec2 p, const Box& box) {
  constexpr double kSlack = 0.5;
  return p.x >= box.left - kSlack && p.x <= box.right + kSlack && p.y >= box.top - kSlack && p.y <= box.bottom + kSlack;
}

bool within(const Box& inner, const Box& outer) {
  return inner.left >= outer.left && inner.right <= outer.right && inner.top >= outer.top &&
         inner.bottom <= outer.bottom;
}

std::vector<std::vector<Vec2>> clipped(const std::vector<Vec2>& line, const Box& box) {
  std::vector<std::vector<Vec2>> parts;
  for (std::size_t i = 1; i < line.size(); ++i) {
    Vec2 a = line[i - 1], b = line[i];
    if (!cut(a, b, box)) continue;
    if (parts.empty() || !(parts.back().back() == a)) parts.push_back({a});
    parts.back().push_back(b);
  }
  return parts;
}

}  // namespace asperity::render
