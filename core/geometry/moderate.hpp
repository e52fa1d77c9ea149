#pragma once
#include <span>

#include "core/base/vec2.hpp"

namespace asperity {

/// Throws Error(numerical) unless all positions (mm) are numbers that leave room for squares and sums. After a blow-up
/// they are not, and algorithms that put them in order may never end.
void require_moderate(std::span<const Vec2> positions);

}  // namespace asperity
