#pragma once
#include <functional>
#include <string_view>
#include <vector>

#include "core/confrontation/naming.hpp"

namespace asperity {

/// What a confrontation ends with.
enum class VerdictStatus { nothing_found, named, indistinguishable, two_causes, unexplained };

std::string_view word(VerdictStatus status);

struct Conclusion {
  VerdictStatus status = VerdictStatus::nothing_found;
  std::vector<HypothesisFit> singles;  ///< Refitted candidates, the best fit first.
  std::vector<SecondCause> seconds;    ///< Of the first singles, where a second cause was sought.
  std::vector<HypothesisFit> pairs;    ///< The best fit first.
  std::vector<HypothesisFit> kept;     ///< What the data do not refute: singles, or pairs; the best fit first (confront
                                    ///< puts those whose runs lack a peak last).
};

/// Whether each amplitude of a pair lies farther from 0 than twice its error: else one cause alone does the same.
bool both_act(const HypothesisFit& pair);

/// Makes the hypothesis of these causes: in the linear frame, or by runs.
using HypothesisMaker = std::function<std::vector<Hypothesis>(const std::vector<std::vector<Eigen::Index>>&)>;

/// Steps 6 to 8 of the method: refits, names, and seeks a second cause; never a third.
Conclusion conclude(const Comparison& comparison, const Scatter& scatter, const BaseFit& fit, const Gate& gate,
                    const std::vector<Candidate>& candidates, const HypothesisMaker& make,
                    const NamingOptions& options);

}  // namespace asperity
