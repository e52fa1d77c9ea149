#pragma once
#include <cmath>

#include "core/contact/bonded_contacts.hpp"

/// Walks around mesh vertices. Corner k of triangle t has index 3 t + k, as the edge that begins there.
namespace asperity {

/// The next edge of the same triangle.
inline int following_edge(int edge) { return 3 * (edge / 3) + (edge % 3 + 1) % 3; }

/// The edge that bounds a corner counter-clockwise: it arrives there.
inline int arriving_edge(int corner) { return 3 * (corner / 3) + (corner % 3 + 2) % 3; }

/// The corner that follows counter-clockwise around the same vertex, beyond arriving_edge(); -1 at the outline.
inline int next_corner(const BondedContacts& contacts, int corner) { return contacts.partner(arriving_edge(corner)); }

/// Angle of a corner at rest, rad.
inline double corner_angle(const Particles& p, int corner) {
  const auto& nodes = p.triangles[corner / 3];
  const int k = corner % 3;
  const Vec2 at = p.reference(nodes[k]);
  const Vec2 a = p.reference(nodes[(k + 1) % 3]) - at, b = p.reference(nodes[(k + 2) % 3]) - at;
  return std::atan2(cross(a, b), dot(a, b));
}

}  // namespace asperity
