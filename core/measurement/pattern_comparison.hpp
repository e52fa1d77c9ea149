#pragma once
#include <array>

#include "core/measurement/crack_pattern.hpp"
#include "core/measurement/frame.hpp"

/// How alike two failure patterns are: orientation of their cracks, place of their damage.
namespace asperity {

inline constexpr std::size_t kOrientationBins = 18;
inline constexpr double kOrientationBinDeg = 180.0 / kOrientationBins;

/// Shares of crack length by the angle from the loading axis, Eq. (M40): bin i holds -90 + 10 i to -80 + 10 i degrees.
/// NaN throughout for an empty pattern.
using OrientationShares = std::array<double, kOrientationBins>;

OrientationShares orientation_shares(const CrackPattern& pattern);

/// By how many degrees a piece of crack has to be turned on average to make one distribution of orientation the other,
/// Eqs. (M41), (M42): 0 to 90. NaN where a pattern is empty.
double orientation_distance_deg(const CrackPattern& a, const CrackPattern& b);

/// Whether two frames show the same particles at rest, to a micrometre.
bool same_mesh(const Frame& a, const Frame& b);

/// Share of damage that two frames of one mesh have in common, particle by particle, Eq. (M43): 0 to 1. NaN where
/// nothing is damaged.
double damage_overlap_on_mesh(const Frame& a, const Frame& b);

/// The same over the squares of a common grid at rest, `cell_mm` wide, Eqs. (M43), (M44): for any two meshes.
double damage_overlap_on_grid(const Frame& a, const Frame& b, double cell_mm);

/// Mean length of the particles' edges at rest, mm; of a frame with at least one.
double mean_edge_mm(const Frame& frame);

}  // namespace asperity
