#pragma once
#include <cmath>
#include <numbers>

#include "core/base/random.hpp"
#include "core/measurement/crack_pattern.hpp"

namespace asperity::testing {

/// Cracks from place to place, one after the other; their vertices are numbered from `first` on.
inline CrackPattern chain(const std::vector<Vec2>& places, BreakMode mode, int first = 0) {
  CrackPattern pattern;
  for (int i = 0; i + 1 < static_cast<int>(places.size()); ++i) {
    pattern.push_back({{first + i, first + i + 1}, {places[i], places[i + 1]}, mode});
  }
  return pattern;
}

/// `pieces` equal cracks along a straight line, zigzagging by `sway` (mm) to either side.
inline CrackPattern straight(Vec2 from, Vec2 to, int pieces, BreakMode mode, int first = 0, double sway = 0.0) {
  std::vector<Vec2> places;
  const Vec2 along = (1.0 / norm(to - from)) * (to - from), aside{along.y, -along.x};
  for (int i = 0; i <= pieces; ++i) {
    const double offset = i % 2 == 0 ? -sway : sway;
    places.push_back(from + (static_cast<double>(i) / pieces) * (to - from) + offset * aside);
  }
  return chain(places, mode, first);
}

/// Single cracks of `length` mm, at random all over a rectangle that stands on y = 0, its middle at x = 0.
inline CrackPattern scattered(int count, double width, double height, double length, std::uint64_t seed = 1) {
  RandomStream random(seed, "test cracks");
  CrackPattern pattern;
  for (int i = 0; i < count; ++i) {
    const Vec2 middle{random.uniform(-0.5 * width, 0.5 * width), random.uniform(0.0, height)};
    const double angle = random.uniform(0.0, std::numbers::pi);
    const Vec2 half = (0.5 * length) * Vec2{std::sin(angle), std::cos(angle)};
    pattern.push_back({{2 * i, 2 * i + 1}, {middle - half, middle + half}, BreakMode::tension});
  }
  return pattern;
}

inline CrackPattern operator+(CrackPattern a, const CrackPattern& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace asperity::testing
