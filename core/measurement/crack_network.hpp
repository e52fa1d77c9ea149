#pragma once
#include <vector>

#include "core/contact/bonded_contacts.hpp"
#include "core/measurement/frame.hpp"
#include "core/particles/particles.hpp"

namespace asperity {

/// One broken contact edge: a row of cracks.csv. Place and orientation are those of the undeformed edge.
struct Crack {
  int contact = 0;
  BreakMode mode = BreakMode::none;
  double time_s = 0;
  Vec2 place;                  ///< Middle of the edge, mm.
  double orientation_deg = 0;  ///< From the x axis, 0 to 180.
  double length_mm = 0;
  double energy_n_mm = 0;  ///< Fracture energy, per mm of thickness.
};

/// All broken edges, ordered by time and then by contact.
std::vector<Crack> list_cracks(const BondedContacts& contacts, const Particles& particles);

/// Number of contact edges by state; softening ones have damage or one broken point.
struct CrackCounts {
  int tension = 0, shear = 0, softening = 0;
  CrackCounts& operator+=(const CrackCounts& other);
};

CrackCounts count_cracks(const BondedContacts& contacts, const ParallelLoops& loops);

/// Softening and broken edges at their present place, for pictures and VTU.
std::vector<CrackSegment> crack_segments(const BondedContacts& contacts, const Particles& particles);

/// Fracture energy of one contact edge, N mm per mm of thickness.
double edge_fracture_energy(const BondedContacts& contacts, std::size_t edge);

}  // namespace asperity
