#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/confrontation/scatter.hpp"
#include "core/confrontation/whitened.hpp"

namespace asperity {

struct GateOptions {
  int draws = 400;
  std::uint64_t seed = 1;
  double explained_level = 0.02;  ///< Of the largest explained part.
  double misfit_level = 1e-4;     ///< Of the whole misfit.
  NoiseOptions noise;
  std::function<void()> at_each_draw = [] {};  ///< May throw, to end where the user wants to.
};

/// What one comparison shows beyond calibration; Eqs. (N14), (N15).
struct Pattern {
  double misfit = 0;          ///< T0 = |r|^2
  Eigen::VectorXd explained;  ///< By candidate: Lambda, the part of it that an amplitude of its sign takes away.
};

/// A candidate's effect is tried by its first runs and by its second, N21: Lambda is the larger one.
Pattern pattern_of(const WhitenedFrame& frame, const Eigen::VectorXd& difference, const Comparison& comparison,
                   const std::vector<Candidate>& candidates);

/// By candidate its projected fingerprint, a unit of amplitude; of a setting that was run either way, on the side that
/// explains more of the difference.
Eigen::MatrixXd projected_fingerprints(const WhitenedFrame& frame, const Eigen::VectorXd& difference,
                                       const Comparison& comparison);

/// Whether calibration leaves a discrepancy: double parametric bootstrap, in which every draw estimates its own
/// covariance. `fit` is the base's calibration of the very comparison.
struct Gate {
  Pattern pattern;
  double p_explained = 1, p_misfit = 1;  ///< The latter by a gamma law through the draws' misfits.
  double p_too_good = 1;  ///< Share of draws by the meshes' scatter alone that fit as well: near 0, too good a fit.
  Eigen::Index left = 0;  ///< Directions of the data that calibration does not absorb.
  bool discrepancy = false;
  Eigen::VectorXd hidden_share;  ///< By candidate: 1 - eta, what calibration absorbs of its fingerprint.
  Eigen::VectorXd detectable;    ///< By candidate: amplitude that would have been seen, Eq. (N16); infinite: none.
};

Gate gate(const Comparison& comparison, const Scatter& scatter, const BaseFit& fit,
          const std::vector<Candidate>& candidates, const GateOptions& options);

/// Error of the model's mean at the fitted parameters, from the errors of their effects, drawn.
Eigen::VectorXd drawn_parameter_error(const Comparison& comparison, const BaseFit& fit, RandomStream& random);

/// Share of draws at or above a value, never 0: (their number + 1) / (draws + 1).
double share_above(const std::vector<double>& draws, double value);

/// Probability of a value beyond `value` under the gamma law with the mean and the variance of the sample.
double gamma_tail(const std::vector<double>& sample, double value);

}  // namespace asperity
