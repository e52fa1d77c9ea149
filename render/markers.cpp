#include "render/markers.hpp"

#include <cmath>
#include <numbers>

#include "render/style.hpp"

namespace asperity::render {
namespace {

constexpr double kCasing = 2.5, kOpenEdge = 3;  // pixels
constexpr double kStarInner = 0.45;             // parts of the radius

/// Corners of a regular figure, one of them straight up or, turned by half a step, a side on top.
std::vector<Vec2> regular(Vec2 centre, double radius, int corners, double turn) {
  std::vector<Vec2> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * (i + turn) / corners;
    points.push_back(centre + radius * Vec2{std::sin(angle), -std::cos(angle)});
  }
  return points;
}

void add_star(Drawing& drawing, Vec2 centre, double radius, Colour fill) {
  const std::vector<Vec2> outer = regular(centre, radius, 5, 0), inner = regular(centre, kStarInner * radius, 5, 0.5);
  drawing.shapes.push_back(Polygon{inner, fill});
  for (std::size_t i = 0; i < 5; ++i) drawing.shapes.push_back(Polygon{{inner[(i + 4) % 5], outer[i], inner[i]}, fill});
}

void add_cross(Drawing& drawing, Vec2 centre, double radius, const Stroke& stroke) {
  const Vec2 one = radius * Vec2{1, 1}, other = radius * Vec2{1, -1};
  add_line(drawing, centre - one, centre + one, stroke);
  add_line(drawing, centre - other, centre + other, stroke);
}

/// One solid shape; the radii are chosen so that all shapes look equally large.
void add_solid(Drawing& drawing, Vec2 centre, MarkerShape shape, double radius, Colour fill) {
  using enum MarkerShape;
  if (shape == disc || shape == ring) add_disc(drawing, centre, radius, fill);
  if (shape == square || shape == open_square)
    drawing.shapes.push_back(Polygon{regular(centre, 1.25 * radius, 4, 0.5), fill});
  if (shape == diamond || shape == open_diamond)
    drawing.shapes.push_back(Polygon{regular(centre, 1.3 * radius, 4, 0), fill});
  if (shape == triangle) drawing.shapes.push_back(Polygon{regular(centre, 1.35 * radius, 3, 0), fill});
  if (shape == star) add_star(drawing, centre, 1.7 * radius, fill);
}

bool is_open(MarkerShape shape) {
  using enum MarkerShape;
  return shape == ring || shape == open_square || shape == open_diamond;
}

}  // namespace

void add_marker(Drawing& drawing, Vec2 centre, const Marker& marker) {
  if (marker.shape == MarkerShape::cross) {
    add_cross(drawing, centre, 0.8 * marker.radius + 1, {style::kPaper, 8, {}, Cap::butt});
    add_cross(drawing, centre, 0.8 * marker.radius, {marker.colour, 4, {}, Cap::butt});
    return;
  }
  add_solid(drawing, centre, marker.shape, marker.radius + kCasing, style::kPaper);
  add_solid(drawing, centre, marker.shape, marker.radius, marker.colour);
  if (is_open(marker.shape)) add_solid(drawing, centre, marker.shape, marker.radius - kOpenEdge, style::kPaper);
}

}  // namespace asperity::render
