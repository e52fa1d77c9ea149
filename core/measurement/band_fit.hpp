#pragma once
#include "core/measurement/crack_pattern.hpp"

namespace asperity {

/// The straight band through a compression specimen that holds most crack length; Eqs. (M22), (M23).
struct FailureBand {
  double angle_deg = 0;      ///< From the loading axis, positive where it leans to the right.
  double share = 0;          ///< Of the crack length that lies in it.
  double concentration = 0;  ///< Share over the band's share of the specimen's area: 1 for cracks scattered evenly.
};

/// Width of the band over the specimen's.
inline constexpr double kBandWidth = 0.2;
/// Flattest band looked for, degrees from the loading axis: shear bands of Mohr-Coulomb are steeper than 45.
inline constexpr int kFlattestBand = 60;

/// The best band of a specimen of `width` by `height` mm that stands on y = 0, its middle at x = 0. Among whole degrees
/// and places a twentieth of the band's width apart; bands that only cut off a corner (their mean length below the
/// specimen's width) are left out. NaN throughout for an empty pattern.
FailureBand fit_band(const CrackPattern& pattern, double width, double height);

}  // namespace asperity
