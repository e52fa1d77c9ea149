#pragma once
#include <vector>

#include "core/confrontation/confront.hpp"

namespace asperity {

/// Of one extension, over all compared features of fitted and kept-back tests: those that at least half of the base's
/// runs give, and fewer than half as many of the extension's.
std::vector<ShortRuns> short_runs(const ConfrontationTask& task, const Confrontation& state, const HypothesisFit& fit);

}  // namespace asperity
