#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "core/base/vec2.hpp"
#include "core/contact/contact_points.hpp"

namespace asperity {

/// Where forces on nodes are written before each node gathers them. A *slot* is a pair of forces: those on the two ends
/// of one triangle edge, in the triangle's own direction. Contact c has one for its left triangle (ends 1, 2) and one
/// for its right triangle (ends 2, 1); eight contacts' left slots lie before their right ones, as the packed points do.
/// Behind the contacts' slots lie those of the outline's edges.
inline std::size_t contact_slot(std::size_t contact, std::size_t side) {
  return (contact / kPacked) * 2 * kPacked + side * kPacked + contact % kPacked;
}
inline std::size_t contact_slot_count(std::size_t contacts) { return (contacts + kPacked - 1) / kPacked * 2 * kPacked; }
inline std::size_t contact_of_slot(std::size_t slot) { return slot / (2 * kPacked) * kPacked + slot % kPacked; }
inline std::size_t side_of_slot(std::size_t slot) { return slot / kPacked % 2; }

/// Roles of a contact's four nodes.
enum class ContactNode : std::size_t { left1 = 0, left2 = 1, right2 = 2, right1 = 3 };

/// Index, into a list of forces, of the force on one of a contact's nodes.
inline std::size_t force_index(std::size_t contact, ContactNode node) {
  const auto role = static_cast<std::size_t>(node);
  return 2 * contact_slot(contact, role / 2) + role % 2;
}

/// All forces: the slots, and behind them, where there is a gather list, three forces for each triangle's corners.
struct ForceSlots {
  std::span<Vec2> all;
  std::span<const int> slot_of_edge;
  std::size_t corners = 0;  ///< Index of the first corner's force; 0: there are none.

  /// Where a force on a corner is added: among the corners', or else at the start of the edge that begins there.
  Vec2& on_corner(int corner) const {
    return all[corners > 0 ? corners + corner : 2 * static_cast<std::size_t>(slot_of_edge[corner])];
  }
};

}  // namespace asperity
