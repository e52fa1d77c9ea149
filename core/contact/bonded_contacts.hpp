#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/base/vec2.hpp"
#include "core/config/run_config.hpp"
#include "core/contact/contact_points.hpp"
#include "core/contact/force_slots.hpp"
#include "core/contact/law.hpp"
#include "core/geometry/mesh.hpp"
#include "core/particles/particles.hpp"

namespace asperity {

/// One contact edge between two particles. Nodes (left1, left2) and (right1, right2) coincide at rest; seen along
/// 1 -> 2 the left particle lies to the left. Edge k of triangle t, from its corner k to the next, has index 3 t + k.
struct ContactEdge {
  int left1, left2, right1, right2;
  int left_edge, right_edge;  ///< Of the two triangles.
  double length;              ///< At rest, mm: the contact area per mm of thickness, twice that of one contact point.
  int left_triangle() const { return left_edge / 3; }
  int right_triangle() const { return right_edge / 3; }
};

/// How far a broken contact has passed over to the general contact, Eqs. (C44), (C45).
struct HandOver {
  double opening = 0, slip = 0;  ///< Mean separation when it broke, mm.
  double weight = 1;             ///< Of its own pair's law; 1 until it breaks, 0 for good once it is released.
};

/// Slip or opening since breakage, over the edge length, at which a broken contact has passed over; Eq. (C44).
inline constexpr double kHandOverRange = 0.05;

/// Stops at the two ends of an edge of which a point has broken, Eq. (C53): without them an edge could hinge about its
/// other point and its end sink into the neighbour, where no point feels it.
struct EndStops {
  std::array<double, 2> rest{0, 0};  ///< mm: an end whose opening is below this is stopped; 0: not armed yet.
  double energy = 0;                 ///< At weight 1, N mm per mm of thickness.
};

/// What an edge remembers once one of its points is broken.
struct BrokenEdge {
  std::array<BreakMode, 2> points{BreakMode::none, BreakMode::none};
  std::uint8_t defect = 0;  ///< 1 where it was open before the test.
  double break_time = -1;   ///< s, when the second point broke; -1 before.
  HandOver hand_over;
  EndStops end_stops;
};

/// What joins a triangle's edge to the triangle beyond it: the index of a bonded contact, or one of these.
inline constexpr int kOutline = -1;  ///< Nothing: the edge lies on the outline.
inline constexpr int kGrain = -2;    ///< The same grain: the two share their nodes for good.

/// Factors on the strengths of kPacked contacts side by side.
struct alignas(64) StrengthRow {
  std::array<double, kPacked> factor;
};

/// Contact edges of a mesh and the memory of their two contact points (Gauss points at 1/2 -+ 1/(2 sqrt 3)).
struct BondedContacts {
  std::vector<ContactEdge> edges;
  ContactPoints memory;
  std::vector<int> broken_index;   ///< Of each edge into `broken`; -1 while both its points hold.
  std::vector<BrokenEdge> broken;  ///< In the order in which they first broke.
  std::vector<int> slot_of_edge;   ///< Of each triangle edge: its force slot; -2 - e inside a grain, e the edge beyond.
  std::size_t outline_edges = 0;   ///< Their slots follow the contacts'.
  std::vector<StrengthRow> strengths;  ///< Factors of eight contacts each, Eq. (C57); empty: 1 everywhere.
  double hand_over_range = 0;  ///< Edge lengths of slip or opening since breakage; 0: they keep their pair for good.
  LawParameters law;
  LawReading reading = LawReading::consistent;
  LawForm form = LawForm::damage_slip;  ///< Of the default law.

  std::size_t size() const { return edges.size(); }
  std::size_t slot_count() const { return contact_slot_count(size()) + outline_edges; }

  /// The two contact points of an edge with their traction at the last update.
  std::array<PointState, 2> points(std::size_t contact) const;
  /// Sets them; a broken one enters the list of broken edges.
  void set_points(std::size_t contact, const std::array<PointState, 2>& points);

  double strength(std::size_t contact) const;  ///< Factor of its strengths, Eq. (C57).

  double break_time(std::size_t contact) const;  ///< s; -1 while the edge holds.
  bool is_broken(std::size_t contact) const { return break_time(contact) >= 0.0; }
  bool is_defect(std::size_t contact) const;  ///< Open before the test.
  bool is_crack(std::size_t contact) const { return is_broken(contact) && !is_defect(contact); }
  double weight(std::size_t contact) const;  ///< Of its own pair's law, see HandOver.
  /// Its entry in the list of broken edges, a new one where it had none.
  BrokenEdge& broken_edge(std::size_t contact);

  int joint(int edge) const;    ///< Of a triangle's edge: a contact, kOutline or kGrain.
  int partner(int edge) const;  ///< The edge beyond it; -1 on the outline.
};

/// Contacts on all edges between triangles of different grains.
BondedContacts make_contacts(const Mesh& mesh, const Particles& particles, const LawParameters& law, LawReading reading,
                             LawForm form = LawForm::damage_slip);

/// Gives every contact its own strength, a factor above 0 each, Eq. (C57).
void set_strengths(BondedContacts& contacts, const std::vector<double>& factors);

/// The law of one contact, with its strength, Eq. (C57).
LawParameters law_of(const BondedContacts& contacts, std::size_t contact);

/// Breaks a contact before anything moves: a defect, which transmits pressure and friction and nothing else. It is no
/// crack of the test.
void open_from_start(BondedContacts& contacts, std::size_t contact);

/// Midline frame of a contact edge and its separations; Eqs. (C15), (C16).
struct ContactFrame {
  Vec2 tangent, normal;
  double midline_length;
  std::array<Vec2, 2> gap;  ///< right - left at ends 1 and 2, mm.
};

inline ContactFrame contact_frame(Vec2 left1, Vec2 left2, Vec2 right1, Vec2 right2) {
  const Vec2 midline = 0.5 * ((left2 - left1) + (right2 - right1));
  const double length = norm(midline);
  const Vec2 tangent = (1.0 / length) * midline;
  return {tangent, {tangent.y, -tangent.x}, length, {right1 - left1, right2 - left2}};
}

inline ContactFrame contact_frame(const ContactEdge& edge, const std::vector<Vec2>& x) {
  return contact_frame(x[edge.left1], x[edge.left2], x[edge.right1], x[edge.right2]);
}

/// The frame at rest.
inline ContactFrame reference_frame(const ContactEdge& edge, const Particles& p) {
  return contact_frame(p.reference(edge.left1), p.reference(edge.left2), p.reference(edge.right1),
                       p.reference(edge.right2));
}

/// Weights of ends 1 and 2 at the two contact points.
inline constexpr double kNearGauss = 0.78867513459481287;
inline constexpr double kFarGauss = 0.21132486540518713;

/// How the forces are computed: both give the same, but for rounding.
enum class Kernel {
  fast,       ///< Vector registers, the instruction set chosen at run time.
  reference,  ///< One contact, triangle and node after the other, as the equations read.
};

/// Brings every contact to the present positions at `time` (s) and writes its forces (N per mm of thickness), Eqs.
/// (C17), (C18), into its slots (force_index()). Returns how many broke or were released. The literal law and the
/// cohesive-frictional form always take the reference kernel.
int update_contacts(BondedContacts& contacts, const std::vector<Vec2>& position, double time,
                    const ParallelLoops& loops, std::span<Vec2> forces, Kernel kernel = Kernel::fast);

/// Adds to a contact's four forces what the change of its weight gives back or takes, Eq. (C48); `general_energy` (N mm
/// per mm of thickness) is that of the general contacts which gain weight as it loses its own.
void add_hand_over_force(const BondedContacts& contacts, std::size_t contact, double general_energy,
                         const std::vector<Vec2>& position, std::span<Vec2> forces);

/// Energies of all contacts, N mm per mm of thickness.
struct ContactEnergies {
  double recoverable = 0, fracture = 0, friction = 0, created = 0;
  ContactEnergies& operator+=(const ContactEnergies& other);
};

ContactEnergies contact_energies(const BondedContacts& contacts, const ParallelLoops& loops);

/// An edge is broken once both its points are; its mode is that of the point that spent more fracture energy.
BreakMode edge_break_mode(const std::array<PointState, 2>& points);

/// Mean damage of the two points; a broken point counts 1.
double edge_damage(const std::array<PointState, 2>& points);

}  // namespace asperity
