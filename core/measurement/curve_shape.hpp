#pragma once
#include <optional>
#include <vector>

#include "core/measurement/branch.hpp"
#include "core/measurement/curve.hpp"
#include "core/measurement/curve_loops.hpp"

namespace asperity {

/// Where a curve has its landmarks: what all features start from.
struct CurveShape {
  CurveReading reading;
  Curve first;    ///< Rows of first loading; loads as recorded.
  Branch branch;  ///< The same, load above the base.
  std::vector<CurveLoop> loops;
  std::vector<Branch> unloading, reloading;  ///< Of each loop that comes back.
  std::size_t smoothing_rows = 0;            ///< Eq. (F2).
  std::size_t peak_row = 0;                  ///< Of first loading.
  double peak = 0;                           ///< Load above the base; Eq. (F4).
  double peak_path = 0;
  bool peak_passed = false;
  std::optional<Line> line;  ///< Path over load in the modulus window, before the peak; Eq. (F5).
};

/// Number of rows before the path first exceeds the limit within which a peak is sought.
std::size_t rows_in_reach(std::span<const double> path, double limit);

/// Fewer rows than this are no curve.
inline constexpr std::size_t kLeastRows = 10;

/// Finds loops, peak and modulus line. A curve of fewer than kLeastRows rows has no landmark: its peak is not passed.
CurveShape shape_of(const Curve& curve, const CurveReading& reading);

}  // namespace asperity
