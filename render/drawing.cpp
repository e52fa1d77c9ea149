#include "render/drawing.hpp"

#include <cmath>
#include <numbers>

namespace asperity::render {

void add_box(Drawing& drawing, const Box& box, Colour fill) {
  drawing.shapes.push_back(
      Polygon{{{box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}}, fill});
}

void add_frame(Drawing& drawing, const Box& box, const Stroke& stroke) {
  const double half = 0.5 * stroke.width;  // the horizontal sides fill the corners
  add_line(drawing, {box.left - half, box.top}, {box.right + half, box.top}, stroke);
  add_line(drawing, {box.left - half, box.bottom}, {box.right + half, box.bottom}, stroke);
  add_line(drawing, {box.left, box.top}, {box.left, box.bottom}, stroke);
  add_line(drawing, {box.right, box.top}, {box.right, box.bottom}, stroke);
}

void add_line(Drawing& drawing, Vec2 from, Vec2 to, const Stroke& stroke) {
  drawing.shapes.push_back(Polyline{{from, to}, stroke});
}

void add_disc(Drawing& drawing, Vec2 centre, double radius, Colour fill) {
  constexpr int kCorners = 32;
  Polygon disc{{}, fill};
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    disc.corners.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  drawing.shapes.push_back(disc);
}

}  // namespace asperity::render
