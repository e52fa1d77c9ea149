#pragma once
#include <vector>

#include "core/confrontation/confrontation_config.hpp"

namespace asperity {

/// What a bank is known by: one run of each kind of test at the configuration's own parameters, then one of every
/// mechanism that may be a cause, of the first test of the kind that computes fastest among those in which it acts. A
/// build that gives the same features computes base and mechanisms as the bank's build did.
std::vector<RunConfig> golden_runs(const ConfrontationConfig& config);

}  // namespace asperity
