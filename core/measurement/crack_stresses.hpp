#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "core/measurement/results.hpp"

namespace asperity {

/// Volumetric strain of a compression test and what it tells of cracking, after Martin & Chandler (1994); contraction
/// positive. In two dimensions it is the change of area.
struct CrackStresses {
  std::vector<double> volumetric;        ///< Eq. (M39), one a row.
  std::vector<double> crack_volumetric;  ///< Eq. (M40), one a row.
  std::optional<double> initiation_mpa;  ///< sigma_ci, Eq. (M41): total axial stress.
  std::optional<double> damage_mpa;      ///< sigma_cd, Eq. (M42): the same.
  std::size_t initiation_row = 0, damage_row = 0;
};

/// The crack volumetric strain counts as still at its largest within this share of the largest contraction.
inline constexpr double kDilationOnset = 0.02;

/// A compression test's curve: how far the platens have closed (any unit), and what moduli are read from.
struct CompressionColumns {
  std::span<const double> path;
  ElasticColumns elastic;
};

/// Of a curve up to its peak's row; `window` as in elastic_slopes. Rows on ways back (unloading) are left out. Empty
/// where the window holds too few rows. A stress is unset where its reversal does not come before the peak.
std::optional<CrackStresses> crack_stresses(const CompressionColumns& columns, std::size_t peak,
                                            const StressRange& window, double confining_pressure_mpa);

/// Total axial stresses of a run's modulus window, from its configuration and peak.
StressRange elastic_window(const RunConfig& config, double peak_mpa);

}  // namespace asperity
