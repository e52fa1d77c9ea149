#pragma once
#include <vector>

#include "core/calibration/emulator.hpp"
#include "core/calibration/optimum.hpp"
#include "core/calibration/target.hpp"

namespace asperity {

/// Parameters given the targets: a normal prior about the design's centre, emulators, and the scatter of what will be
/// compared with the targets.
struct PosteriorProblem {
  std::vector<Emulator> emulators;  ///< One a target.
  std::vector<Target> targets;
  std::vector<double> noise;  ///< Variance of a batch's mean and of the target, one a target.
  double prior_sd = 1;
  SearchRegion region;
};

/// Mode and, by linearisation there, covariance.
struct Posterior {
  std::vector<double> theta;
  std::vector<double> covariance;  ///< k by k.
  double cost = 0;                 ///< Eq. (S33).
};

/// Gauss-Newton on Eq. (S33), drawn back into the region, from `start` and from points over the region; the best end
/// counts. The covariance is Eq. (S35).
Posterior find_mode(const PosteriorProblem& problem, const std::vector<double>& start);

}  // namespace asperity
