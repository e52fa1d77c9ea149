#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "core/calibration/design.hpp"
#include "core/calibration/desirability.hpp"

/// Where the next design goes when no solution lies inside this one.
namespace asperity {

struct MoveOptions {
  DesirabilityOptions desirability;
  double most = 1.0;  ///< Longest move, in units of the design's alpha.
};

/// The next design's factors.
struct Move {
  std::vector<Factor> factors;               ///< With the new centres and steps.
  std::vector<double> coded;                 ///< The new centre in the old design's coding.
  double moved_by = 0;                       ///< Coded length; 0 where the merit cannot be raised from the centre.
  double merit_before = 0, merit_after = 0;  ///< Of Eq. (S22), at the old and the new centre.
  std::vector<bool> limited;  ///< One a factor: its lower or upper limit held the centre back or shrank the step.
};

/// The path of steepest ascent of the merit from the design's centre, Eq. (S28), at most `most` alpha long; then drawn
/// back where the new design's star points would leave a factor's limits (and the step shrunk where even the middle
/// between the limits leaves too little room).
Move next_centre(const Design& design, const ResponseSystem& system, const MoveOptions& options);

}  // namespace asperity
