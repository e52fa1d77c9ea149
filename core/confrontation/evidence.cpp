#include "core/confrontation/evidence.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {

double amplitude_of_run(const Candidate& candidate, double amplitude) {
  const double within = std::clamp(amplitude, candidate.two_sided ? -candidate.most : 0.0, candidate.most);
  if (candidate.whole) return std::round(within);
  return std::abs(within) < candidate.least ? 0.0 : within;
}

}  // namespace asperity
