#include "core/geometry/outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {
namespace {

double angle_along(const Side& side, double along) { return side.start_angle + along / side.radius; }

SidePoint nearest_on_arc(const Side& side, Vec2 p) {
  const Vec2 d = p - side.centre;
  double angle = std::atan2(d.y, d.x) - side.start_angle;
  // Measured from the middle of the arc, so that points beyond either end are cut off at that end.
  const double half = 0.5 * side.swept_angle;
  angle = half + std::remainder(angle - half, 2.0 * std::numbers::pi);
  const double along = std::clamp(angle * side.radius, 0.0, side.length());
  return {along, side.at(along)};
}

}  // namespace

double Side::length() const { return radius > 0.0 ? radius * swept_angle : norm(end - start); }

Vec2 Side::at(double along) const {
  if (along <= 0.0) return start;
  if (along >= length()) return end;
  if (radius <= 0.0) return start + (along / length()) * (end - start);
  const double angle = angle_along(*this, along);
  return centre + radius * Vec2{std::cos(angle), std::sin(angle)};
}

Vec2 Side::tangent(double along) const {
  if (radius <= 0.0) return (1.0 / length()) * (end - start);
  const double angle = angle_along(*this, along);
  return {-std::sin(angle), std::cos(angle)};
}

SidePoint Side::nearest(Vec2 p) const {
  if (radius > 0.0) return nearest_on_arc(*this, p);
  const double along = std::clamp(dot(p - start, tangent(0.0)), 0.0, length());
  return {along, at(along)};
}

Side straight_side(Vec2 start, Vec2 end) {
  Side side;
  side.start = start;
  side.end = end;
  return side;
}

OutlinePoint nearest_on(const Outline& outline, Vec2 p) {
  OutlinePoint best{-1, 0.0, {}};
  for (int s = 0; s < static_cast<int>(outline.sides.size()); ++s) {
    const SidePoint found = outline.sides[s].nearest(p);
    if (best.side < 0 || norm(found.point - p) < norm(best.point - p)) best = {s, found.along, found.point};
  }
  return best;
}

}  // namespace asperity
