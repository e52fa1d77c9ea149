#pragma once
#include <vector>

#include "core/contact/bonded_contacts.hpp"
#include "core/contact/pieces.hpp"
#include "core/particles/particles.hpp"

namespace asperity {

/// Connected pieces of the specimen: triangles joined by a shared particle or an unbroken contact edge.
struct Fragments {
  std::vector<int> of_triangle;  ///< Number of each triangle's fragment, 0 the largest by area.
  std::vector<double> area_mm2;  ///< Per fragment, falling.
};

/// Those of a time (s) not after the present.
Fragments find_fragments(const BondedContacts& contacts, const Particles& particles, double time_s = kNow);

}  // namespace asperity
