#pragma once
#include "core/base/disjoint_sets.hpp"
#include "core/contact/bonded_contacts.hpp"
#include "core/particles/particles.hpp"

namespace asperity {

/// Triangles that hang together by a grain or by unbroken contacts.
DisjointSets bonded_pieces(const BondedContacts& contacts, const Particles& particles);

}  // namespace asperity
