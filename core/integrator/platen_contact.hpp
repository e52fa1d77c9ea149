#pragma once
#include <cmath>

#include "core/integrator/system.hpp"

/// Where a point stands to the platens' faces; Eqs. (I5), (I20), (I24).
namespace asperity {

/// A point against one platen's face.
struct PlatenTouch {
  double depth = 0;  ///< Behind the face, mm; negative in front of it.
  Vec2 normal;       ///< Of the face, towards the specimen.
  double bend = 0;   ///< 1/mm: by how much the normal turns when the point moves along the face; 0 where it is level.
};

/// +1 for the bottom platen, -1 for the top one: the way its face looks along y.
inline double facing(int side) { return side == 0 ? 1.0 : -1.0; }

/// A point (mm) against the face of the platen `side` at its present place.
inline PlatenTouch platen_touch(const Platens& platens, int side, Vec2 point) {
  const double up = facing(side);
  const double above = up * (point.y - platens.y[side]);
  const JawFace& jaw = platens.jaw;
  if (jaw.radius == 0.0) return {-above, {0.0, up}, 0.0};
  const Vec2 arm{point.x - jaw.centre_x, above - jaw.radius};
  const double distance = norm(arm);
  if (jaw.depth - above < distance - jaw.radius) return {jaw.depth - above, {0.0, up}, 0.0};
  return {distance - jaw.radius, {-arm.x / distance, -up * arm.y / distance}, 1.0 / distance};
}

/// How much higher the upper face stands over a place along the specimen at rest (mm) than the platen; Eq. (I24).
inline double face_rise(const Platens& platens, double rest_x) {
  return platens.upper.slope * (rest_x - platens.upper.pivot_x);
}

/// Height below which no node of the specimen is behind the upper face, mm.
inline double lowest_of_upper_face(const Platens& platens) {
  return platens.y[1] - std::abs(platens.upper.slope) * platens.upper.reach;
}

/// Along the face, in the direction of x where it is level.
inline Vec2 along_face(const PlatenTouch& touch, int side) {
  return facing(side) * Vec2{touch.normal.y, -touch.normal.x};
}

/// The platen that a node presses, and how.
struct PlatenContact {
  int side = 0;
  PlatenTouch touch;
  PlatenSpring spring;
  double overlap = 0;  ///< mm beyond the spring's skin; above 0 where it presses.
};

/// At present positions; where no face is passed, the overlap is not above 0 and the rest without meaning.
inline PlatenContact platen_contact(const System& system, std::size_t node) {
  const Vec2 point = system.particles.position[node];
  PlatenContact contact{0, platen_touch(system.platens, 0, point), {}, 0};
  if (contact.touch.depth <= 0.0) {
    const double rise = face_rise(system.platens, system.particles.reference(node).x);
    contact = {1, platen_touch(system.platens, 1, point - Vec2{0.0, rise}), {}, 0};
  }
  if (contact.touch.depth <= 0.0) return contact;
  contact.spring = system.platen_springs.at(node);
  contact.overlap = contact.touch.depth - contact.spring.skin;
  return contact;
}

}  // namespace asperity
