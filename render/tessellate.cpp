#include "render/tessellate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::render {
namespace {

constexpr double kCloserIsOne = 0.5;     // pixels
constexpr double kJoinsFromWidth = 2.5;  // pixels; thinner lines show no gap at a corner

using Triangles = std::vector<Triangle>;

void fill_fan(const std::vector<Vec2>& corners, Colour fill, Triangles& out) {
  for (std::size_t i = 2; i < corners.size(); ++i) out.push_back({{corners[0], corners[i - 1], corners[i]}, fill});
}

void fill_band(const Band& band, Triangles& out) {
  for (std::size_t i = 1; i < band.lower.size(); ++i) {
    const Vec2 a = band.lower[i - 1], b = band.lower[i], c = band.upper[i], d = band.upper[i - 1];
    out.push_back({{a, b, c}, band.fill});
    out.push_back({{a, c, d}, band.fill});
  }
}

void fill_joint(Vec2 centre, const Stroke& stroke, Triangles& out) {
  const double radius = 0.5 * stroke.width;
  const int sides = std::clamp(static_cast<int>(3 * std::sqrt(stroke.width)), 6, 24);
  std::vector<Vec2> corners;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    corners.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  fill_fan(corners, stroke.colour, out);
}

void fill_segment(Vec2 a, Vec2 b, const Stroke& stroke, Triangles& out) {
  const double length = norm(b - a);
  if (length <= 0) return;
  const Vec2 side = (0.5 * stroke.width / length) * Vec2{a.y - b.y, b.x - a.x};
  fill_fan({a + side, b + side, b - side, a - side}, stroke.colour, out);
}

void fill_stroke(const Polyline& line, Triangles& out) {
  const bool round = line.stroke.cap == Cap::round;
  for (const auto& part : dashes(line)) {
    for (std::size_t i = 1; i < part.size(); ++i) fill_segment(part[i - 1], part[i], line.stroke, out);
    if (line.stroke.width < kJoinsFromWidth) continue;
    for (std::size_t i = round ? 0 : 1; i + (round ? 0 : 1) < part.size(); ++i) fill_joint(part[i], line.stroke, out);
  }
}

std::vector<Vec2> thinned(const std::vector<Vec2>& points) {
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool far = kept.empty() || norm(points[i] - kept.back()) >= kCloserIsOne;
    if (far || i + 1 == points.size()) kept.push_back(points[i]);
  }
  return kept;
}

struct Tessellator {
  Triangles& out;
  void operator()(const Triangle& triangle) const { out.push_back(triangle); }
  void operator()(const Polygon& polygon) const { fill_fan(polygon.corners, polygon.fill, out); }
  void operator()(const Band& band) const { fill_band(band, out); }
  void operator()(const Polyline& line) const { fill_stroke(line, out); }
  void operator()(const Text&) const {}
};

}  // namespace

std::vector<std::vector<Vec2>> dashes(const Polyline& line) {
  const std::vector<Vec2> points = thinned(line.points);
  if (line.stroke.dash.empty() || points.size() < 2) return {points};
  std::vector<std::vector<Vec2>> parts{{points[0]}};
  std::size_t entry = 0;
  double left = line.stroke.dash[0];
  for (std::size_t i = 1; i < points.size(); ++i) {
    Vec2 from = points[i - 1];
    double length = norm(points[i] - from);
    while (length > left) {
      from += (left / length) * (points[i] - from);
      length -= left;
      if (entry % 2 == 0) parts.back().push_back(from);
      entry = (entry + 1) % line.stroke.dash.size();
      if (entry % 2 == 0) parts.push_back({from});
      left = line.stroke.dash[entry];
    }
    left -= length;
    if (entry % 2 == 0) parts.back().push_back(points[i]);
  }
  return parts;
}

std::vector<Triangle> tessellate(const Drawing& drawing) {
  Triangles triangles;
  triangles.reserve(drawing.shapes.size());
  for (const Shape& shape : drawing.shapes) std::visit(Tessellator{triangles}, shape);
  return triangles;
}

}  // namespace asperity::render
