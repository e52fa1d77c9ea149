#pragma once
#include <array>

#include "core/measurement/crack_pattern.hpp"

namespace asperity {

/// The straight bands through a compression specimen that hold most crack length, Eqs. (M22), (M23), (M29): the first,
/// and the second of the cracks outside it, as conjugate bands come. NaN where there is none.
struct FailureBands {
  std::array<double, 2> angle_deg;  ///< From the loading axis, positive where it leans to the right.
  std::array<double, 2> share;      ///< Of the whole crack length that lies in it; the second without the first's.
  double concentration =
      0;  ///< Both shares over the bands' share of the specimen's area: 1 for cracks scattered evenly.
  double significance = 0;  ///< That above 1, over what chance scatters as many cracks by; Eq. (M29).
};

/// Width of a band: over the specimen's, and over the mean crack's length where that is wider, so that a zigzag fits.
inline constexpr double kBandWidth = 0.1, kBandCracks = 1.5;
/// Flattest band looked for, degrees from the loading axis: shear bands of Mohr-Coulomb are steeper than 45.
inline constexpr int kFlattestBand = 60;

/// The best bands of a specimen of `width` by `height` mm that stands on y = 0, its middle at x = 0. Among whole
/// degrees and places a sixteenth of the band's width apart; bands that only cut off a corner (their mean length below
/// the specimen's width) are left out.
FailureBands fit_bands(const CrackPattern& pattern, double width, double height);

}  // namespace asperity
