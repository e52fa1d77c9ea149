#include "core/contact/touch_entry.hpp"

#include <algorithm>

#include "core/base/power.hpp"
#include "core/contact/surface_wear.hpp"

namespace asperity {
namespace {

/// Edge of a triangle nearest to a point inside it.
int nearest_edge(const PresentTriangle& t, Vec2 point) {
  int nearest = 0;
  for (int k = 1; k < 3; ++k) {
    if (t.depth(k, point) < t.depth(nearest, point)) nearest = k;
  }
  return nearest;
}

/// Two different surfaces together: the smoother one's friction, both penalties in series; Eq. (C51).
SurfaceLaw together(const SurfaceLaw& a, const SurfaceLaw& b) {
  const auto series = [](double k, double l) { return 2.0 * k * l / (k + l); };
  return {std::min(a.tan_phi, b.tan_phi), series(a.k_n, b.k_n), series(a.k_s, b.k_s)};
}

/// Law of an exposed edge's surface as it has worn so far, Eq. (C55).
SurfaceLaw present_surface(const GeneralContacts& general, const ContactMember& member, int k) {
  SurfaceLaw law = general.law.surfaces[member.surface[k]];
  if (!general.wear.empty()) law.tan_phi = worn_friction(law, general.wear[3 * member.triangle + k]);
  return law;
}

}  // namespace

TouchPoint touch_point(const PresentTriangle& own, const PresentTriangle& other, int k, const EdgePart& part) {
  TouchPoint point;
  point.s = part.m1 / part.m0;
  const Vec2 along = edge_vector(own, k);
  point.tangent = (1.0 / norm(along)) * along;
  const Vec2 at = position_on_edge(own, k, point.s);
  for (int i = 0; i < 3; ++i) point.share[(i + 2) % 3] = other.depth(i, at) / other.height[i];
  return point;
}

SurfaceLaw surface_law(const GeneralContacts& general, const Entry& entry, Vec2 at) {
  const ContactMember &own = general.members[entry.own], &other = general.members[entry.other];
  const int facing = nearest_edge(general.frames[entry.other], at);
  SurfaceLaw law = present_surface(general, own, entry.k);
  if (other.surface[facing] < 0) return law;
  const SurfaceLaw other_law = present_surface(general, other, facing);
  if (own.surface[entry.k] != other.surface[facing]) return together(law, other_law);
  law.tan_phi = std::min(law.tan_phi, other_law.tan_phi);
  return law;
}

double friction_limit(const SurfaceLaw& law, double normal, double length) {
  const double straight = law.tan_phi * normal;
  if (law.exponent == 1.0 || length <= 0.0) return straight;
  const double bent = law.bend * 2.0 * normal / length;
  return bent > 0.0 ? straight * (power(1.0 + bent, law.exponent) - 1.0) / (law.exponent * bent) : straight;
}

void fix_penalties(const GeneralContacts& general, Touch& touch) {
  SurfaceLaw law = general.law.surfaces[static_cast<int>(SurfaceKind::fracture)];
  double largest = 0.0;
  for (int i = 0; i < 6; ++i) {
    const Entry entry = entry_of(general.pairs[touch.pair], i);
    if (touch.parts[i].m0 <= largest || !is_exposed(general, entry)) continue;
    largest = touch.parts[i].m0;
    law = surface_law(general, entry, position_on_edge(general.frames[entry.own], entry.k, touch.parts[i].centre()));
  }
  touch.k_n = law.k_n;
  touch.k_s = law.k_s;
}

double effective_length(const GeneralContacts& general, const Touch& touch, const Entry& entry, int i) {
  const double part = touch.parts[i].end - touch.parts[i].begin;
  return touch.parts[i].m0 > 0.0 ? touch.weight * part * edge_length(general.frames[entry.own], entry.k) : 0.0;
}

}  // namespace asperity
