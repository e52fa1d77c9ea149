#pragma once
#include <vector>

#include "core/confrontation/confront.hpp"

namespace asperity {

/// Hypotheses by runs: each extension where it was run and fits best, with its effects there; Eq. (N19). Those that
/// come near the best stand on all meshes of the base's scatter, the others on the common ones.
std::vector<Hypothesis> hypotheses_by_runs(const ConfrontationTask& task, const Confrontation& state,
                                           const std::vector<std::vector<Eigen::Index>>& lists);

}  // namespace asperity
