#pragma once
#include <limits>

#include "core/base/disjoint_sets.hpp"
#include "core/contact/bonded_contacts.hpp"
#include "core/particles/particles.hpp"

namespace asperity {

inline constexpr double kNow = std::numeric_limits<double>::infinity();

/// Triangles that hang together by a grain or by contacts that were not broken at a time (s).
DisjointSets bonded_pieces(const BondedContacts& contacts, const Particles& particles, double time_s = kNow);

}  // namespace asperity
