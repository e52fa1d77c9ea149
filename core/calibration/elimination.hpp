#pragma once
#include <string>
#include <vector>

#include "core/calibration/linear_fit.hpp"

namespace asperity {

/// Which terms backward elimination may take: `hierarchical` keeps a factor's linear term as long as an interaction or
/// square with it stays, so that the model does not depend on where the factor's zero is; `free` takes any.
enum class Hierarchy { hierarchical, free };

/// What is left, and what went, first to last.
struct Elimination {
  LinearFit fit;
  std::vector<std::string> eliminated;
};

/// Backward elimination: refits without the term of largest p value, until none that may go is above `level`. The
/// constant stays. The paper names the method but neither level nor rule; ours are 0.05 and hierarchical.
Elimination eliminate(const Observations& observed, const LinearFit& full, double level, Hierarchy hierarchy);

}  // namespace asperity
