#pragma once
#include <vector>

#include "core/confrontation/confrontation_task.hpp"

namespace asperity {

/// Which further test would part the causes that the data leave, for every pair of the best three, the one that parts
/// them best first. Each test is simulated under each cause, with its own parameters and amplitude, on four meshes;
/// D^2 = d' (V/n + C_k + C_l)^-1 d, Eq. (N18). Empty unless several single causes are kept. Throws what runs throw.
std::vector<NextTest> next_tests(const ConfrontationConfig& config, const ConfrontationTask& task,
                                 const Confrontation& confrontation);

}  // namespace asperity
