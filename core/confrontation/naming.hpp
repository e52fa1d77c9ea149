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
  double excess = 0;           ///< T_k less the least T of all hypotheses.
  double p_excess = 0;         ///< Share of draws under this hypothesis in which it lies as far behind the best.
  bool converged = true;       ///< As the hypothesis says.
  bool kept = false;           ///< Both shares at or above the level: it may be the cause.
};

struct NamingOptions {
  GateOptions draws;
  double level = 0.01;
  double near = 30;            ///< Candidates whose explained part lies within this of the best are refitted ...
  std::size_t most = 6;        ///< ... at most so many.
  std::size_t most_pairs = 3;  ///< Single causes that a second one is sought to.
};

/// The hypothesis with every parameter that its refit would take beyond what is believed held at that limit: there it
/// absorbs nothing more.
Hypothesis held_within(Hypothesis hypothesis, const std::vector<CalibratedParameter>& parameters,
                       const Eigen::MatrixXd& covariance, const std::vector<Candidate>& candidates);

/// Refits one hypothesis: all of HypothesisFit but what draws and rivals say.
HypothesisFit fit_hypothesis(const Eigen::MatrixXd& covariance, const std::vector<Candidate>& candidates,
                             const Hypothesis& hypothesis);

/// The candidates worth a refit, the one that explains most first.
std::vector<Eigen::Index> refit_candidates(const Gate& gate, const NamingOptions& options);

/// The hypothesis of these causes in the linear frame about the base's calibration.
Hypothesis linear_hypothesis(const Comparison& comparison, const BaseFit& fit, std::vector<Eigen::Index> causes);

/// Refits all and keeps those that the data do not refute, by draws under each; in the order given.
std::vector<HypothesisFit> judge(const Comparison& comparison, const Scatter& scatter, const BaseFit& fit,
                                 const std::vector<Candidate>& candidates, const std::vector<Hypothesis>& hypotheses,
                                 const NamingOptions& options);

/// What a second cause would add to a first.
struct SecondCause {
  Eigen::Index candidate = -1;  ///< That explains most of what the first leaves; -1: none explains any.
  double explained = 0;
  double p = 1;  ///< Share of draws under the first alone in which a second one explains as much.
};

SecondCause second_cause(const Comparison& comparison, const Scatter& scatter, const BaseFit& fit,
                         const std::vector<Candidate>& candidates, const Hypothesis& first,
                         const NamingOptions& options);

/// Cosine between two candidates' fingerprints after projection.
double cosine(const WhitenedFrame& frame, const Comparison& comparison, Eigen::Index a, Eigen::Index b);

}  // namespace asperity
