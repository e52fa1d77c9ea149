#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/vec2.hpp"
#include "core/contact/bonded_contacts.hpp"
#include "core/particles/particles.hpp"

/// Where the confining pressure acts once pieces come off: on the present outer surface, Eqs. (I15)-(I17). Three steps:
/// which triangles carry, where the outline of what carries runs, which of its edges are seen from the sides.
namespace asperity {

/// An edge with no bonded neighbour: of the outline, or one face of a broken contact. Its own particle is on its left.
struct ExposedEdge {
  std::array<int, 2> nodes;
  int triangle;
  bool under_platen = false;  ///< An end of the specimen: it hides what is behind, but takes no pressure.
};

/// An exposed edge that the pressure reaches, and the share of it, in (0, 1], that is seen.
struct LoadedEdge {
  std::array<int, 2> nodes;
  double share;
};

/// Which triangles (1 or 0) belong to a held fragment: one with a triangle on a platen, or one that touches a held
/// fragment. A fragment is what unbroken contacts or a shared grain connect; `on_platen` has an entry for every
/// triangle, `touching` the pairs of triangles that press on each other.
std::vector<std::uint8_t> carrying_triangles(const BondedContacts& contacts, const Particles& particles,
                                             std::span<const std::uint8_t> on_platen,
                                             std::span<const std::array<int, 2>> touching);

/// Name of each node's group: the nodes of one corner of the mesh that unbroken contacts still hold together. It
/// changes only when a contact breaks.
std::vector<int> joined_nodes(const BondedContacts& contacts, std::size_t node_count);

/// Positions (mm) with every node at the mean of its group, Eq. (I15): the outline of every fragment is a closed line,
/// though its contacts have opened or overlap a little.
std::vector<Vec2> closed_positions(const std::vector<Vec2>& position, const std::vector<int>& joined);

/// The edges seen from the left (along +x) or from the right, Eq. (I16), in the order of `exposed`: at every height the
/// outermost edge of a carrying triangle that faces the side. An edge of which nothing is hidden has share 1.0 exactly.
/// `position` (mm) should be closed; gaps let the pressure in. O(n log n) where edges do not cross. Throws
/// Error(numerical) where a position is no number, as after a blow-up.
std::vector<LoadedEdge> find_loaded_edges(const std::vector<Vec2>& position, std::span<const ExposedEdge> exposed,
                                          std::span<const std::uint8_t> carries);

/// Force of the pressure (MPa) on each of the edge's two nodes at the present positions, N per mm of thickness; Eq.
/// (I17).
inline Vec2 pressure_on_end(const LoadedEdge& edge, const std::vector<Vec2>& position, double pressure) {
  const Vec2 along = position[edge.nodes[1]] - position[edge.nodes[0]];
  return (edge.share * (-0.5 * pressure)) * Vec2{along.y, -along.x};
}

}  // namespace asperity
