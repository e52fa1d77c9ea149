#pragma once
#include "core/measurement/band_fit.hpp"
#include "core/measurement/crack_pattern.hpp"
#include "core/measurement/fragments.hpp"

/// How a specimen failed, read off its cracks; shares are of length, NaN where there is none.
namespace asperity {

/// Cracks by mode.
struct CrackTotals {
  int tension = 0, shear = 0;
  double length_mm = 0;
  double tension_share = 0;  ///< Of the length.
};

CrackTotals crack_totals(const CrackPattern& pattern);

/// Half the width of a disc's central band, and the depth of its ends under the platens, over the diameter.
inline constexpr double kCentralBand = 0.1, kDiscEnd = 0.15;

/// A disc's cracks; Eqs. (M24)-(M26).
struct DiscFailure {
  CrackTotals cracks;
  AxialStatistics orientation;
  double tension_in_central_band = 0;  ///< Share of the tension cracks' length.
  double near_platens = 0;             ///< Share of all cracks' length in the two ends.
  CrackPattern path;                   ///< Shortest way along cracks from end to end.
  bool splits() const { return !path.empty(); }
  double path_tension_share() const;
  double path_offset_mm() const;  ///< Farthest of its places from the loaded diameter; NaN without a path.
  const char* verdict() const;    ///< Eq. (M26): "tension split", "shear split", "no split", "none".
};

/// A disc that stands on y = 0, its centre at x = 0.
DiscFailure disc_failure(const CrackPattern& pattern, double diameter_mm);

/// Share of the specimen's width or height that a cluster must cover to span it.
inline constexpr double kSpan = 0.95;
/// Concentration and significance from which cracks lie in bands, and the flattest split, degrees from the loading
/// axis.
inline constexpr double kConcentrated = 1.7, kSignificant = 5.0, kAxial = 15.0;

/// A compression specimen's cracks; Eqs. (M16)-(M23), (M27).
struct CompressionFailure {
  CrackTotals cracks;
  AxialStatistics orientation;
  double cluster_share = 0;  ///< Of the length, in the largest cluster.
  PrincipalDirection cluster;
  double cluster_width_share = 0, cluster_height_share = 0;  ///< What it covers of the specimen's width and height.
  FailureBands bands;
  double width_mm = 0;  ///< Of the specimen.
  bool spans_width() const { return cluster_width_share >= kSpan; }
  bool spans_height() const { return cluster_height_share >= kSpan; }
  const char* verdict() const;  ///< "oblique band", "axial splitting", "diffuse", "none"; Eq. (M27).
};

/// A specimen that stands on y = 0, its middle at x = 0.
CompressionFailure compression_failure(const CrackPattern& pattern, double width_mm, double height_mm);

/// Area shares of the two largest fragments; the second is 0 where there is one.
struct FragmentShares {
  double largest = 0, second = 0;
};

FragmentShares fragment_shares(const Fragments& fragments);

}  // namespace asperity
