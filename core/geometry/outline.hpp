#pragma once
#include <vector>

#include "core/base/vec2.hpp"
#include "core/geometry/mesh.hpp"

namespace asperity {

/// The point of a side nearest to a given point, at arc length `along` from the side's start (mm).
struct SidePoint {
  double along;
  Vec2 point;
};

/// One smooth piece of an outline from corner `start` to corner `end`: a straight line, or an arc where radius > 0.
/// The specimen lies to its left. Lengths in mm.
struct Side {
  Vec2 start, end;
  Vec2 centre{};             ///< Arc only.
  double radius = 0.0;       ///< 0 for a straight side.
  double start_angle = 0.0;  ///< Arc only, radians.
  double swept_angle = 0.0;  ///< Arc only, radians, positive: counter-clockwise.

  double length() const;
  /// The point at arc length `along`; exactly `start` and `end` at the ends, exactly on the line where it is parallel
  /// to an axis.
  Vec2 at(double along) const;
  /// Unit vector in the direction of growing arc length.
  Vec2 tangent(double along) const;
  SidePoint nearest(Vec2 p) const;
};

/// A closed chain of sides, counter-clockwise: each side ends where the next one starts.
struct Outline {
  std::vector<Side> sides;
  double area_mm2 = 0.0;
};

Side straight_side(Vec2 start, Vec2 end);

/// A point on an outline.
struct OutlinePoint {
  int side;
  double along;
  Vec2 point;
};

/// The outline's point nearest to p.
OutlinePoint nearest_on(const Outline& outline, Vec2 p);

}  // namespace asperity
