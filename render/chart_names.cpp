#include <algorithm>
#include <cmath>

#include "render/chart_layers.hpp"
#include "render/style.hpp"
#include "render/text_metrics.hpp"

namespace asperity::render {
namespace {

constexpr double kNameSize = 24;     // pixels
constexpr double kNameGap = 6;       // between a point's marker and its name, pixels
constexpr double kArrowRoom = 20;    // around an arrow's tip, pixels
constexpr double kErrorRoom = 5;     // around an error bar, pixels
constexpr double kCapHeight = 0.73;  // of DejaVu Sans, parts of the size

Box around(Vec2 centre, double x, double y) { return {centre.x - x, centre.y - y, centre.x + x, centre.y + y}; }

void reserve_points(const PlotArea& area, const PointLayer& layer, Occupied& occupied) {
  for (std::size_t i = 0; i < std::min(layer.x.size(), layer.y.size()); ++i) {
    const Vec2 at = area.place(layer.x[i], layer.y[i]);
    if (!near_box(at, area.box)) continue;
    occupied.boxes.push_back(around(at, 1.4 * layer.marker.radius, 1.4 * layer.marker.radius));
    for (const Vec2 arm : error_arms(area, layer, i))
      occupied.boxes.push_back(around(at, arm.x + kErrorRoom, arm.y + kErrorRoom));
  }
}

void reserve_line(const std::vector<Vec2>& points, double width, const void* layer, Occupied& occupied) {
  for (const Vec2 p : points) occupied.lines.push_back({around(p, width, width), layer});
}

/// The four edges of a rectangle.
void reserve_edges(const PlotArea& area, const BoxLayer& layer, Occupied& occupied) {
  const Vec2 a = area.place(layer.x.low, layer.y.high), b = area.place(layer.x.high, layer.y.low);
  const double w = layer.edge->width;
  for (const double x : {a.x, b.x}) occupied.lines.push_back({{x - w, a.y - w, x + w, b.y + w}, &layer});
  for (const double y : {a.y, b.y}) occupied.lines.push_back({{a.x - w, y - w, b.x + w, y + w}, &layer});
}

void reserve_cased(const PlotArea& area, const LineLayer& layer, Occupied& occupied) {
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < std::min(layer.x.size(), layer.y.size()); ++i)
    points.push_back(area.place(layer.x[i], layer.y[i]));
  reserve_line(points, layer.stroke.width, &layer, occupied);
}

void reserve_contour(const PlotArea& area, const ContourLayer& layer, Occupied& occupied) {
  for (const auto& line : contour_lines(layer.grid, layer.level)) {
    std::vector<Vec2> points;
    for (const Vec2 p : line) points.push_back(area.place(p.x, p.y));
    reserve_line(points, layer.stroke.width, &layer, occupied);
  }
}

/// The places for a name around a point: right, left, above, below, then the corners, then all of them farther off.
std::vector<Text> places(Vec2 at, double radius, const std::string& name) {
  const double off = radius + kNameGap, up = 0.5 * kCapHeight * kNameSize, down = off + kCapHeight * kNameSize;
  std::vector<Text> found;
  const auto add = [&](Vec2 shift, Anchor anchor) {
    found.push_back({at + shift, name, kNameSize, anchor, Weight::regular, Direction::across, style::kInk});
  };
  for (const double far : {1.0, 1.8, 2.8, 4.0}) {
    add({far * off, up}, Anchor::left);
    add({-far * off, up}, Anchor::right);
    add({0, -far * off}, Anchor::centre);
    add({0, far * down}, Anchor::centre);
    for (const double y : {-far * off, far * down}) {
      add({far * off, y}, Anchor::left);
      add({-far * off, y}, Anchor::right);
    }
  }
  return found;
}

bool meet(const Box& a, const Box& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

}  // namespace

bool Occupied::free(const Box& box) const {
  return std::none_of(boxes.begin(), boxes.end(), [&](const Box& other) { return meet(box, other); });
}

bool Occupied::free_of_curves(const Box& box) const {
  return std::all_of(curves.begin(), curves.end(),
                     [&](const std::vector<Vec2>& curve) { return clipped(curve, box).empty(); });
}

bool Occupied::free_of_lines_but(const void* layer, const Box& box) const {
  return std::none_of(lines.begin(), lines.end(),
                      [&](const Piece& piece) { return piece.layer != layer && meet(box, piece.box); });
}

void reserve(const PlotArea& area, const Layer& layer, Occupied& occupied) {
  if (const auto* points = std::get_if<PointLayer>(&layer)) reserve_points(area, *points, occupied);
  if (const auto* box = std::get_if<BoxLayer>(&layer); box && box->edge) reserve_edges(area, *box, occupied);
  if (const auto* line = std::get_if<LineLayer>(&layer)) {
    if (line->casing > 0) reserve_cased(area, *line, occupied);
    for (auto& run : finite_runs(area, line->x, line->y)) occupied.curves.push_back(std::move(run));
    for (const std::size_t at : line->arrows)
      occupied.boxes.push_back(around(area.place(line->x[at], line->y[at]), kArrowRoom, kArrowRoom));
  }
  if (const auto* contour = std::get_if<ContourLayer>(&layer)) reserve_contour(area, *contour, occupied);
}

void draw_names(Drawing& drawing, const PlotArea& area, const PointLayer& layer, Occupied& occupied) {
  for (std::size_t i = 0; i < std::min({layer.names.size(), layer.x.size(), layer.y.size()}); ++i) {
    const Vec2 at = area.place(layer.x[i], layer.y[i]);
    if (layer.names[i].empty() || !near_box(at, area.box)) continue;
    const std::vector<Text> all = places(at, layer.marker.radius, layer.names[i]);
    const auto free = [&](const Text& text) {
      return within(text_box(text), area.box) && occupied.free(text_box(text));
    };
    auto text = std::find_if(all.begin(), all.end(),
                             [&](const Text& t) { return free(t) && occupied.free_of_curves(text_box(t)); });
    if (text == all.end()) text = std::find_if(all.begin(), all.end(), free);
    if (text == all.end()) continue;
    drawing.shapes.push_back(*text);
    occupied.boxes.push_back(text_box(*text));
  }
}

}  // namespace asperity::render
