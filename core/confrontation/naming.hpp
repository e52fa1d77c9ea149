#pragma once
#include <Eigen/Core>
#include <vector>

#include "core/confrontation/hypothesis.hpp"

namespace asperity {

struct NamingOptions {
  GateOptions draws;
  double level = 0.01;
  double near = 30;            ///< Candidates whose explained part lies within this of the best are refitted ...
  std::size_t most = 6;        ///< ... at most so many.
  std::size_t most_pairs = 3;  ///< Single causes that a second one is sought to.
};

/// The candidates worth a refit, the one that explains most first.
std::vector<Eigen::Index> refit_candidates(const Gate& gate, const NamingOptions& options);

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

/// Between two directions; 0 where one has no length.
double cosine(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

}  // namespace asperity
