#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/base/vec2.hpp"
#include "core/config/run_config.hpp"
#include "core/contact/law.hpp"
#include "core/geometry/mesh.hpp"
#include "core/particles/particles.hpp"

namespace asperity {

/// One contact edge between two particles. Nodes (left1, left2) and (right1, right2) coincide at rest; seen along
/// 1 -> 2 the left particle lies to the left.
struct ContactEdge {
  int left1, left2, right1, right2;
  int left_triangle, right_triangle;
  double length;  ///< At rest, mm: the contact area per mm of thickness, twice that of one contact point.
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

/// Contact edges of a mesh and the memory of their two contact points (Gauss points at 1/2 -+ 1/(2 sqrt 3)).
struct BondedContacts {
  std::vector<ContactEdge> edges;
  std::vector<std::array<PointState, 2>> points;
  std::vector<double> break_time;  ///< s, when the second point of an edge broke; -1 before.
  std::vector<HandOver> hand_over;
  std::vector<EndStops> end_stops;
  double hand_over_range =
      0;  ///< Edge lengths of slip or opening since breakage; 0: contacts keep their pair for good.
  LawParameters law;
  LawReading reading = LawReading::consistent;

  std::size_t size() const { return edges.size(); }
};

/// Contacts on all edges between triangles of different grains.
BondedContacts make_contacts(const Mesh& mesh, const Particles& particles, const LawParameters& law,
                             LawReading reading);

/// Midline frame of a contact edge and its separations; Eqs. (C15), (C16).
struct ContactFrame {
  Vec2 tangent, normal;
  double midline_length;
  std::array<Vec2, 2> gap;  ///< right - left at ends 1 and 2, mm.
};

inline ContactFrame contact_frame(const ContactEdge& edge, const std::vector<Vec2>& x) {
  const Vec2 l1 = x[edge.left1], l2 = x[edge.left2], r1 = x[edge.right1], r2 = x[edge.right2];
  const Vec2 midline = 0.5 * ((l2 - l1) + (r2 - r1));
  const double length = norm(midline);
  const Vec2 tangent = (1.0 / length) * midline;
  return {tangent, {tangent.y, -tangent.x}, length, {r1 - l1, r2 - l2}};
}

/// Weights of ends 1 and 2 at the two contact points.
inline constexpr double kNearGauss = 0.78867513459481287;
inline constexpr double kFarGauss = 0.21132486540518713;

/// Brings every contact to the present positions at `time` (s) and writes its forces on left1, left2, right1, right2 (N
/// per mm of thickness), Eqs. (C17), (C18), to forces[4 edge] ... forces[4 edge + 3]. Returns how many broke or were
/// released.
int update_contacts(BondedContacts& contacts, const std::vector<Vec2>& position, double time,
                    const ParallelLoops& loops, std::span<Vec2> forces);

/// Adds to a contact's four forces what the change of its weight gives back or takes, Eq. (C48); `general_energy` (N mm
/// per mm of thickness) is that of the general contacts which gain weight as it loses its own.
void add_hand_over_force(const BondedContacts& contacts, std::size_t contact, double general_energy,
                         const std::vector<Vec2>& position, Vec2* forces);

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
