#pragma once
#include <vector>

#include "core/confrontation/confront.hpp"

namespace asperity {

/// Hypotheses by runs: each extension at the parameters and amplitudes that its linear fit gives, on common meshes.
std::vector<Hypothesis> hypotheses_by_runs(const ConfrontationTask& task, const Confrontation& state,
                                           const std::vector<std::vector<Eigen::Index>>& lists);

/// Mean of the kept-back slots under an extension, by runs on the base's fresh meshes.
Eigen::VectorXd extension_mean(const ConfrontationTask& task, const Confrontation& state, const HypothesisFit& fit);

}  // namespace asperity
