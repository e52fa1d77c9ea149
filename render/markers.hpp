#pragma once
#include "render/drawing.hpp"

namespace asperity::render {

/// Shapes that are told apart in grey; the open ones are white inside.
enum class MarkerShape { disc, ring, square, open_square, diamond, open_diamond, triangle, star, cross };

struct Marker {
  MarkerShape shape = MarkerShape::disc;
  Colour colour;
  double radius = 8;  ///< Pixels.
};

/// Draws a marker with a white edge, so that it shows on any colour.
void add_marker(Drawing& drawing, Vec2 centre, const Marker& marker);

}  // namespace asperity::render
