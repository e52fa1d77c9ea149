#pragma once
#include <array>
#include <functional>
#include <vector>

#include "core/contact/bonded_contacts.hpp"
#include "core/particles/particles.hpp"

/// Broken contacts as lines on the mesh at rest: how they are oriented, which hang together, and ways along them.
/// Angles are from the loading axis y, in degrees, positive where a line leans to the right, in (-90, 90].
namespace asperity {

/// One broken contact edge. Cracks that share a mesh vertex hang together.
struct CrackLine {
  std::array<int, 2> vertex;
  std::array<Vec2, 2> end;  ///< mm, at rest.
  BreakMode mode = BreakMode::none;
  double length() const { return norm(end[1] - end[0]); }
  Vec2 middle() const { return 0.5 * (end[0] + end[1]); }
};

using CrackPattern = std::vector<CrackLine>;

/// The contacts broken up to a time (s), in the contacts' order.
CrackPattern crack_pattern(const BondedContacts& contacts, const Particles& particles, double until_s);

double total_length(const CrackPattern& pattern);

/// The cracks that a condition picks.
CrackPattern select(const CrackPattern& pattern, const std::function<bool(const CrackLine&)>& condition);

/// Share of the pattern's length that the condition picks; NaN for an empty pattern.
double length_share(const CrackPattern& pattern, const std::function<bool(const CrackLine&)>& condition);

/// Orientation of the length to the loading axis, by doubled angles; NaN throughout for an empty pattern.
struct AxialStatistics {
  double mean_deg = 0;            ///< Eq. (M17).
  double resultant = 0;           ///< Eq. (M18): 0 no direction, 1 one direction.
  double order_parameter = 0;     ///< Eq. (M16): 1 along the load, 0 no preference, -1 across it.
  double mean_deviation_deg = 0;  ///< Eq. (M19): 45 without preference.
};

AxialStatistics axial_statistics(const CrackPattern& pattern);

/// The connected cracks of largest total length; of equal ones the one with the first crack.
CrackPattern largest_cluster(const CrackPattern& pattern);

/// Direction in which lines lie spread out, from their second moments; Eqs. (M20), (M21).
struct PrincipalDirection {
  double angle_deg = 0;
  double elongation = 0;  ///< Root of the moments' ratio, at least 1; infinite for a straight line.
};

PrincipalDirection principal_direction(const CrackPattern& pattern);

/// The shortest way along cracks from an end that `from` accepts to one that `to` accepts, by places at rest (mm);
/// empty where there is none.
CrackPattern shortest_path(const CrackPattern& pattern, const std::function<bool(Vec2)>& from,
                           const std::function<bool(Vec2)>& to);

}  // namespace asperity
