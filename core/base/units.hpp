#pragma once
#include <numbers>

/// The one consistent set of units inside the core: N, mm, MPa (= N/mm2), s, tonne. Energies are N mm (= mJ).
namespace asperity::units {

inline constexpr double kTonnePerMm3PerKgPerM3 = 1e-12;
inline constexpr double kMpaPerGpa = 1e3;
inline constexpr double kRadPerDeg = std::numbers::pi / 180.0;
/// 1 MPa m^0.5 = sqrt(1000) MPa mm^0.5.
inline constexpr double kMpaSqrtMmPerMpaSqrtM = 31.622776601683793;

}  // namespace asperity::units
