#include "core/geometry/moderate.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"

namespace asperity {

void require_moderate(std::span<const Vec2> positions) {
  constexpr double kMost = 1e100;
  const auto moderate = [](const Vec2& x) { return std::abs(x.x) < kMost && std::abs(x.y) < kMost; };  // false for NaN
  if (std::all_of(positions.begin(), positions.end(), moderate)) return;
  throw Error(
      ErrorKind::numerical,
      "a position is not finite. Likely cause: a time step above the stable one, or a loading rate the specimen "
      "cannot follow; lower integration.safety_factor or experiment.loading.closing_rate_mm_per_s");
}

}  // namespace asperity
