#pragma once
#include <cstddef>
#include <vector>

#include "core/calibration/response_system.hpp"

/// Solutions that are not points: where responses are fewer than factors, or some factor changes none.
namespace asperity {

/// How many directions at x change no response, to 1e-6 of the largest change of any.
std::size_t free_directions(const ResponseSystem& system, const std::vector<double>& x);

/// The point of least |x| on the curve (or surface) of exact solutions through x; x itself where they are no curve.
std::vector<double> nearest_on_curve(const ResponseSystem& system, std::vector<double> x);

}  // namespace asperity
