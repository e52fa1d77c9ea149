#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "core/measurement/curve.hpp"

namespace asperity {

/// A way back of a curve: rows of its beginning, of its lowest path, and of the first row of first loading after it.
struct CurveLoop {
  std::size_t top = 0, bottom = 0;
  std::size_t back = 0;  ///< One past the last row where the curve never comes back.
};

/// The ways back by more than the noise; Eq. (F1).
std::vector<CurveLoop> find_loops(const Curve& curve, const CurveReading& reading);

/// Rows of first loading: all but those inside loops.
std::vector<std::size_t> first_loading_rows(std::size_t rows, std::span<const CurveLoop> loops);

}  // namespace asperity
