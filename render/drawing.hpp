#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/base/vec2.hpp"

namespace asperity::render {

/// An opaque sRGB colour.
struct Colour {
  std::uint8_t r = 0, g = 0, b = 0;
  friend bool operator==(const Colour&, const Colour&) = default;
};

/// A rectangle in pixels: x to the right, y downwards from the picture's top left corner.
struct Box {
  double left = 0, top = 0, right = 0, bottom = 0;
  double width() const { return right - left; }
  double height() const { return bottom - top; }
  Vec2 centre() const { return {0.5 * (left + right), 0.5 * (top + bottom)}; }
};

enum class Cap { butt, round };

/// How a line is drawn; lengths in pixels. `dash` alternates drawn and left-out lengths; empty is a solid line.
struct Stroke {
  Colour colour;
  double width = 1;
  std::vector<double> dash;
  Cap cap = Cap::butt;
};

enum class Anchor { left, centre, right };
enum class Weight { regular, bold };
enum class Direction { across, upwards };

/// One line of UTF-8 text whose baseline passes through `at`; `size` is the font's size in pixels. "_{...}" lowers
/// what it holds ("t_{c}").
struct Text {
  Vec2 at;
  std::string text;
  double size = 24;
  Anchor anchor = Anchor::left;
  Weight weight = Weight::regular;
  Direction direction = Direction::across;
  Colour colour;
};

struct Triangle {
  std::array<Vec2, 3> corners;
  Colour fill;
};

/// A filled convex polygon.
struct Polygon {
  std::vector<Vec2> corners;
  Colour fill;
};

/// The area between two curves over the same ascending x: from `lower` to `upper`.
struct Band {
  std::vector<Vec2> lower, upper;
  Colour fill;
};

struct Polyline {
  std::vector<Vec2> points;
  Stroke stroke;
};

using Shape = std::variant<Triangle, Polygon, Band, Polyline, Text>;

/// A picture as a list of shapes in pixels, drawn in order on white; one list gives both the PNG and the SVG.
struct Drawing {
  int width = 1600, height = 1200;
  std::vector<Shape> shapes;
};

void add_box(Drawing& drawing, const Box& box, Colour fill);
void add_frame(Drawing& drawing, const Box& box, const Stroke& stroke);
void add_line(Drawing& drawing, Vec2 from, Vec2 to, const Stroke& stroke);
void add_disc(Drawing& drawing, Vec2 centre, double radius, Colour fill);

}  // namespace asperity::render
