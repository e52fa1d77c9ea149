#include "render/rose.hpp"

#include <cmath>
#include <numbers>

#include "render/style.hpp"

namespace asperity::render {
namespace {

constexpr int kRingPieces = 90, kArcPieces = 6;
constexpr double kTick = 7;  // pixels

/// A place at an angle (rad) from the vertical, positive to the right.
Vec2 on_circle(Vec2 centre, double radius, double angle) {
  return centre + radius * Vec2{std::sin(angle), -std::cos(angle)};
}

void draw_wedge(Drawing& drawing, Vec2 centre, double radius, double from, double to) {
  Polygon wedge{{centre}, style::kBlue};
  for (int i = 0; i <= kArcPieces; ++i)
    wedge.corners.push_back(on_circle(centre, radius, from + (to - from) * i / kArcPieces));
  drawing.shapes.push_back(wedge);
  wedge.corners.push_back(centre);
  drawing.shapes.push_back(Polyline{wedge.corners, {style::kPaper, 1, {}, Cap::butt}});
}

void draw_ring(Drawing& drawing, Vec2 centre, double radius) {
  Polyline ring{{}, {style::kSoftInk, 1.5, {}, Cap::butt}};
  for (int i = 0; i <= kRingPieces; ++i)
    ring.points.push_back(on_circle(centre, radius, 2 * std::numbers::pi * i / kRingPieces));
  drawing.shapes.push_back(ring);
}

}  // namespace

void draw_rose(Drawing& drawing, Vec2 centre, double radius, const Rose& rose) {
  const double bin = std::numbers::pi / static_cast<double>(rose.shares.size());
  for (std::size_t i = 0; i < rose.shares.size(); ++i) {
    if (!(rose.shares[i] > 0)) continue;
    const double from = -0.5 * std::numbers::pi + static_cast<double>(i) * bin;
    const double reach = radius * std::sqrt(rose.shares[i] / rose.outer);
    draw_wedge(drawing, centre, reach, from, from + bin);
    draw_wedge(drawing, centre, reach, from + std::numbers::pi, from + std::numbers::pi + bin);
  }
  draw_ring(drawing, centre, radius);
  const Stroke tick{style::kSoftInk, 1.5, {}, Cap::butt};
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double angle = 0.5 * std::numbers::pi * quarter;
    add_line(drawing, on_circle(centre, radius, angle), on_circle(centre, radius + kTick, angle), tick);
  }
}

}  // namespace asperity::render
