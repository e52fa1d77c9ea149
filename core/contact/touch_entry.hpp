#pragma once
#include "core/contact/general_contact.hpp"

/// One entry of a touch: an edge of one triangle inside another; its geometry and the law of the surfaces that meet.
namespace asperity {

/// Which edge of which triangle an entry of a touch stands for: edge `k` of member `own`, inside member `other`.
struct Entry {
  int own, other, k;
  int edge() const { return 3 * own + k; }
};

inline Entry entry_of(const MemberPair& pair, int i) {
  return i < 3 ? Entry{pair.a, pair.b, i} : Entry{pair.b, pair.a, i - 3};
}

inline Vec2 edge_vector(const PresentTriangle& t, int k) { return t.x[(k + 1) % 3] - t.x[k]; }
inline double edge_length(const PresentTriangle& t, int k) { return norm(edge_vector(t, k)); }

/// The point at s, 0 to 1, of edge k.
inline Vec2 position_on_edge(const PresentTriangle& t, int k, double s) { return t.x[k] + s * edge_vector(t, k); }

/// Where the forces of edge k's part inside `other` act: the centre of the depth.
TouchPoint touch_point(const PresentTriangle& own, const PresentTriangle& other, int k, const EdgePart& part);

/// Law of the surface of an entry's own edge, which must be exposed.
inline const SurfaceLaw& own_surface(const GeneralContacts& general, const Entry& entry) {
  return general.law.surfaces[general.members[entry.own].surface[entry.k]];
}

/// Law of the surfaces that meet at an entry, as they have worn so far; where the other triangle's nearest edge is not
/// exposed, the own alone.
SurfaceLaw surface_law(const GeneralContacts& general, const Entry& entry, Vec2 at);

inline bool is_exposed(const GeneralContacts& general, const Entry& entry) {
  return general.members[entry.own].surface[entry.k] >= 0;
}

/// What friction holds of the force (N/mm) that presses one of two edges over a contact length (mm), N/mm: Coulomb's,
/// or as bent as the strength of what broke; Eqs. (C47), (C58).
double friction_limit(const SurfaceLaw& law, double normal, double length);

/// Penalties of a new touch: those of its deepest exposed entry.
void fix_penalties(const GeneralContacts& general, Touch& touch);

/// Eq. (C47), mm.
double effective_length(const GeneralContacts& general, const Touch& touch, const Entry& entry, int i);

}  // namespace asperity
