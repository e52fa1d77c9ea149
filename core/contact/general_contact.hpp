#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/contact/bonded_contacts.hpp"
#include "core/contact/contact_member.hpp"
#include "core/contact/overlap.hpp"
#include "core/contact/slip_ledger.hpp"
#include "core/particles/particles.hpp"

/// General contact: every exposed edge may touch any other. Eqs. (C40)-(C56) of core/contact/README.md.
namespace asperity {

/// Friction and penalty of one kind of surface.
struct SurfaceLaw {
  double tan_phi = 0;
  double k_n = 0, k_s = 0;  ///< Normal and tangential penalty, MPa/mm.
  FrictionWear wear = {};   ///< Of tan_phi, Eqs. (C55), (C56).
  double exponent = 1;      ///< Of friction over pressure, Eq. (C58); 1: Coulomb.
  double bend = 0;          ///< tan(phi) / (n c_c) of the same, 1/MPa.
};

struct GeneralContactLaw {
  bool enabled = false;
  std::array<SurfaceLaw, kSurfaceKinds> surfaces;
  double damping_ratio = 0;  ///< Of critical damping, on the normal approach; Eq. (C50).
};

/// What a config says about surfaces, on top of the contacts' own law; on breakage their friction goes on unchanged
/// unless the config says otherwise.
GeneralContactLaw general_contact_law(const RunConfig& config, const LawParameters& law);

/// Seat of a pair that has not met since it last parted.
inline constexpr double kUnseated = std::numeric_limits<double>::infinity();

/// Two members within reach of each other, and the chain of handing-over bonded contacts between them, which sets the
/// weight of their contact, Eq. (C46).
struct MemberPair {
  int a, b;  ///< Member indices, a < b.
  int chain_begin = 0;
  int chain_size = 0;
  int touch = -1;           ///< Index of their touch, -1 while apart.
  double seat = kUnseated;  ///< mm: the overlap that does not count, Eq. (C54).
};

/// Where the forces of an edge inside another triangle act: on the edge at s (0 to 1), on the other triangle with the
/// shape functions `share`.
struct TouchPoint {
  double s = 0;
  std::array<double, 3> share{};
  Vec2 tangent;  ///< Along the edge; turned by -90 degrees it points out of its triangle.

  Vec2 normal() const { return {tangent.y, -tangent.x}; }
};

/// Memory of one exposed edge inside another triangle, at the last update.
struct EdgeFriction {
  double length = 0;   ///< Effective length of contact, Eq. (C47), mm.
  double slip = 0;     ///< Elastic tangential displacement, mm.
  double damping = 0;  ///< Viscous normal force, N per mm of thickness.
  double wear = 0;     ///< In the last update, mm; Eq. (C56).
  TouchPoint point;
};

/// Two triangles that overlap. Entries 0-2: edges of a inside b; 3-5: edges of b inside a.
struct Touch {
  int pair;
  int handing_over = 0;  ///< 1 where bonded contacts still share the pair, weight < 1.
  double weight = 1;
  double k_n = 0, k_s = 0;  ///< Penalties of the two surfaces together, fixed at first touch, MPa/mm.
  double yielded = 0;       ///< Overlap potential that its seat gave up in the last update, mm3, Eq. (C54).
  std::array<EdgePart, 6> parts;
  std::array<EdgeFriction, 6> friction;
};

/// A pair of this weight or more has taken over from the bonds.
inline constexpr double kTakenOver = 0.5;

/// Forces on the corners of two touching triangles: first a's, then b's. N per mm of thickness.
using PairForces = std::array<Vec2, 6>;

/// What an edge's entries have rubbed in one update.
struct EdgeRubbing {
  double length = 0, wear = 0;  ///< mm; length times wear, mm2.
};

/// Members, pairs within reach, and the contacts alive. Everything up to `largest_seat` is the state
/// of a run.
struct GeneralContacts {
  GeneralContactLaw law;
  double skin = 0;        ///< mm: pairs nearer than this are on the list.
  double stiffening = 0;  ///< 1/mm2, Eq. (C40).
  double play = 0;        ///< mm: overlaps up to this count in full, Eq. (C54).

  std::vector<ContactMember> members;
  std::vector<MemberPair> pairs;
  std::vector<int> chain_contacts;
  std::vector<int> handing_over;  ///< Bonded contacts broken and not yet released.
  std::vector<Touch> touches;
  std::vector<double> wear;  ///< Of each triangle's edges so far, mm, Eq. (C56); empty where no surface wears.
  double travel = 0;         ///< mm: bound of what any node has moved since the last search.
  std::uint8_t search_due = 1;
  std::int64_t searches = 0;
  double friction_energy = 0, damping_energy = 0;  ///< N mm per mm of thickness, up to now.
  double largest_depth = 0;                        ///< mm, in the whole run, Eq. (C52).
  double largest_depth_handing_over = 0;           ///< The same of contacts of less than half their weight.
  double largest_seat = 0;                         ///< mm, Eq. (C54).

  std::vector<PresentTriangle> frames;  ///< Of the members, at the last update.
  SlipLedger ledger;                    ///< Work space, like all below.
  std::vector<PairForces> forces;
  std::vector<double> set_free;
  std::vector<EdgeRubbing> rubbing;  ///< Of each triangle's edges, and which are not zero.
  std::vector<int> rubbing_edges;
  std::vector<std::uint8_t> alive;
};

/// General contacts of a mesh; the skin is a fifth of the mean edge.
GeneralContacts make_general_contacts(const Particles& particles, const GeneralContactLaw& law);

/// The members' triangles at the present positions.
void update_frames(GeneralContacts& general, const Particles& particles, const ParallelLoops& loops);

/// Lists members and pairs within reach at the present positions, and carries the live touches over.
void search_pairs(GeneralContacts& general, const BondedContacts& bonded, const Particles& particles,
                  const ParallelLoops& loops);

/// Adds the forces of all touching pairs at the present positions to those on the triangles' corners, and what
/// hand-over gives back to those of the bonded contacts. Friction follows the last step's displacements, velocity times
/// time_step (s). Call after update_contacts().
void update_general_contacts(GeneralContacts& general, const BondedContacts& bonded, const Particles& particles,
                             double time_step, const ParallelLoops& loops, const ForceSlots& forces);

/// Energies stored in the contacts alive at the last update, N mm per mm of thickness: Eqs. (C42), (C49).
struct GeneralContactEnergies {
  double normal = 0, tangential = 0;
  GeneralContactEnergies& operator+=(const GeneralContactEnergies& o) {
    normal += o.normal;
    tangential += o.tangential;
    return *this;
  }
};
GeneralContactEnergies general_contact_energies(const GeneralContacts& general, const ParallelLoops& loops);

/// The contact taken over (W >= 1/2) that is deepest beyond its seat, over what the inradius of the triangle it reaches
/// into leaves it; share 0: none.
struct DeepestTouch {
  double share = 0;
  Vec2 place;  ///< mm
};
DeepestTouch deepest_touch(const GeneralContacts& general);

/// One contact alive, for pictures: N per mm of thickness.
struct TouchForce {
  int triangle_a, triangle_b;
  Vec2 point;            ///< mm
  double normal, shear;  ///< Normal force >= 0, and the magnitude of the tangential one.
};
std::vector<TouchForce> touch_forces(const GeneralContacts& general);

}  // namespace asperity
