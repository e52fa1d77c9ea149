#pragma once
#include <algorithm>
#include <span>

#include "core/base/vec2.hpp"

namespace asperity {

/// An upright rectangle, mm.
struct Box {
  Vec2 low, high;
};

/// The smallest box around points; at least one is needed.
inline Box bounding_box(std::span<const Vec2> points) {
  Box box{points.front(), points.front()};
  for (const Vec2& p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

}  // namespace asperity
