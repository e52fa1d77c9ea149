#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "core/contact/law.hpp"

namespace asperity {

/// Contact edges that share one packed block.
inline constexpr std::size_t kPacked = 8;

/// What eight contact edges remember under the default law, field by field: row [q] holds contact point q of the eight
/// edges side by side, so that a vector register takes neighbours. Units as in PointState. A point's traction follows
/// from the rest; friction energy is kept per edge, the sum of both points.
struct alignas(64) PackedPoints {
  using Row = std::array<double, kPacked>;
  using Rows = std::array<Row, 2>;
  Rows normal, shear, slip, hardening, integrity_n, integrity_s, friction, damage, fracture_energy;
  Row friction_energy;
};

/// Contact points that nothing has happened to.
PackedPoints virgin_points();

/// Memory of all contact points: packed under the default law, plain under the literal one.
class ContactPoints {
 public:
  ContactPoints() = default;
  ContactPoints(std::size_t edges, bool packed);

  /// The two points of an edge, without their traction and mode of breakage where they are packed.
  std::array<PointState, 2> load(std::size_t edge) const;
  void store(std::size_t edge, const std::array<PointState, 2>& points);

  std::vector<PackedPoints> packed;                ///< Empty under the literal law.
  std::vector<std::array<PointState, 2>> literal;  ///< Empty under the default law.
};

}  // namespace asperity
