#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace asperity {

/// What an exposed edge is made of.
enum class SurfaceKind : std::uint8_t { outline = 0, fracture = 1 };
inline constexpr std::size_t kSurfaceKinds = 2;

/// A triangle with at least one exposed vertex: it may touch others.
struct ContactMember {
  int triangle;
  std::array<int, 3> surface;         ///< SurfaceKind of each edge, -1 where it is not exposed.
  std::array<int, 3> next, previous;  ///< Exposed edges (3 member + k) that go on along the surface; -1: none.
};

}  // namespace asperity
