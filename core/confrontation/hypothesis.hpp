#pragma once
#include <Eigen/Core>
#include <vector>

#include "core/confrontation/gate.hpp"

namespace asperity {

/// The base extended by one cause or two, where its model was run: at amplitudes zero in a linear frame.
struct Hypothesis {
  std::vector<Eigen::Index> causes;  ///< Candidates' numbers.
  Eigen::VectorXd amplitude;         ///< At which it was run.
  Eigen::VectorXd coded;             ///< Parameters at which it was run.
  Eigen::VectorXd difference;        ///< Data less that model.
  Eigen::MatrixXd jacobian;          ///< By parameter: change of the model a step, there.
  Eigen::MatrixXd directions;        ///< By cause: change of the model a unit of amplitude, there ...
  Eigen::MatrixXd beyond;            ///< ... and from the knee on; Eq. (N21).
  Eigen::VectorXd knee;              ///< By cause: further amplitude from which on; empty: none has one.
  Eigen::VectorXd bend;              ///< What the causes' effects may be off between their runs, Eq. (N22); or empty.
  Eigen::MatrixXd run_rows;          ///< By runs: their changes against the base, meshes by slots, less their mean.
  bool by_runs = false;              ///< It was run where it fits best: a refit of the data stays there.
  bool converged = true;             ///< False: a linear fit from there still gains more than runs have shown.
};

/// A hypothesis with amplitudes and parameters refitted.
struct HypothesisFit {
  std::vector<Eigen::Index> causes;
  Eigen::VectorXd amplitude, amplitude_error;
  Eigen::VectorXd residual;    ///< Data less the refitted model, without what calibration absorbs.
  Eigen::VectorXd coded;       ///< Parameters, refitted with the amplitudes.
  Eigen::MatrixXd covariance;  ///< Of parameters and amplitudes together.
  double misfit = 0;           ///< T_k
  double p_misfit = 0;         ///< Share of draws under this hypothesis that fit no better.
  double widening = 0;         ///< ln det of its covariance over that without the bend, Eq. (N23).
  double excess = 0;           ///< T_k + widening less the least of all hypotheses, Eq. (N23).
  double p_excess = 0;         ///< Share of draws under this hypothesis in which it lies as far behind the best.
  bool converged = true;       ///< As the hypothesis says.
  bool kept = false;           ///< Both shares at or above the level: it may be the cause.
};

/// The hypothesis of these causes in the linear frame about the base's calibration.
Hypothesis linear_hypothesis(const Comparison& comparison, const BaseFit& fit, std::vector<Eigen::Index> causes);

/// The hypothesis with every parameter that its refit would take beyond what is believed held at that limit: there it
/// absorbs nothing more.
Hypothesis held_within(Hypothesis hypothesis, const std::vector<CalibratedParameter>& parameters,
                       const Eigen::MatrixXd& covariance, const std::vector<Candidate>& candidates);

/// Refits one hypothesis: all of HypothesisFit but what draws and rivals say.
HypothesisFit fit_hypothesis(const Eigen::MatrixXd& covariance, const std::vector<Candidate>& candidates,
                             const Hypothesis& hypothesis);

/// The hypothesis with the bend of its effects at the amplitude that fits, Eq. (N22).
Hypothesis with_bend(Hypothesis hypothesis, const Comparison& comparison, const Eigen::MatrixXd& covariance,
                     const std::vector<Candidate>& candidates);

/// A covariance of data less model with what the hypothesis' effects may be off.
Eigen::MatrixXd bent_covariance(const Eigen::MatrixXd& covariance, const Hypothesis& hypothesis);

/// Least misfit over its causes' ranges, beyond where it was run. `frame` without what its parameters absorb.
AmplitudeFit refit(const WhitenedFrame& frame, const Eigen::VectorXd& difference, const Hypothesis& hypothesis,
                   const std::vector<Candidate>& candidates);

/// What a step of the amplitudes changes, and the slopes where it ends.
Eigen::VectorXd change_of(const Hypothesis& hypothesis, const Eigen::VectorXd& step);
Eigen::MatrixXd slopes_at(const Hypothesis& hypothesis, const Eigen::VectorXd& step);

}  // namespace asperity
