#pragma once
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/contact/bonded_contacts.hpp"

namespace asperity {

/// Opening and shear of a contact point over the separations at which it softens, Eq. (E6).
struct NormalisedSeparation {
  double opening = 0, shear = 0;
  double size() const { return std::hypot(opening, shear); }
};

NormalisedSeparation normalised_separation(const PointState& point, const BondedContacts& contacts,
                                           std::size_t contact);

/// Largest normalised separation of all contact points but those of defects, 1 at first softening; Eq. (E6).
double largest_separation(const BondedContacts& contacts);

/// Contact points whose normalised separation is at least `separation`, without those of defects.
int count_separated(const BondedContacts& contacts, double separation, const ParallelLoops& loops);

}  // namespace asperity
