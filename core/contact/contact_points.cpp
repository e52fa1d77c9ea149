#include "core/contact/contact_points.hpp"

namespace asperity {

PackedPoints virgin_points() {
  PackedPoints block{};
  for (auto* rows : {&block.integrity_n, &block.integrity_s}) {
    for (auto& row : *rows) row.fill(1.0);
  }
  return block;
}

ContactPoints::ContactPoints(std::size_t edges, bool is_packed) {
  if (is_packed) {
    packed.assign((edges + kPacked - 1) / kPacked, virgin_points());
  } else {
    literal.resize(edges);
  }
}

std::array<PointState, 2> ContactPoints::load(std::size_t edge) const {
  if (packed.empty()) return literal[edge];
  const PackedPoints& block = packed[edge / kPacked];
  const std::size_t lane = edge % kPacked;
  std::array<PointState, 2> points;
  for (std::size_t q = 0; q < 2; ++q) {
    PointState& s = points[q];
    s.normal = block.normal[q][lane];
    s.shear = block.shear[q][lane];
    s.slip = block.slip[q][lane];
    s.hardening = block.hardening[q][lane];
    s.integrity_n = block.integrity_n[q][lane];
    s.integrity_s = block.integrity_s[q][lane];
    s.friction = block.friction[q][lane];
    s.damage = block.damage[q][lane];
    s.fracture_energy = block.fracture_energy[q][lane];
  }
  points[0].friction_energy = block.friction_energy[lane];
  return points;
}

void ContactPoints::store(std::size_t edge, const std::array<PointState, 2>& points) {
  if (packed.empty()) {
    literal[edge] = points;
    return;
  }
  PackedPoints& block = packed[edge / kPacked];
  const std::size_t lane = edge % kPacked;
  for (std::size_t q = 0; q < 2; ++q) {
    const PointState& s = points[q];
    block.normal[q][lane] = s.normal;
    block.shear[q][lane] = s.shear;
    block.slip[q][lane] = s.slip;
    block.hardening[q][lane] = s.hardening;
    block.integrity_n[q][lane] = s.integrity_n;
    block.integrity_s[q][lane] = s.integrity_s;
    block.friction[q][lane] = s.friction;
    block.damage[q][lane] = s.damage;
    block.fracture_energy[q][lane] = s.fracture_energy;
  }
  block.friction_energy[lane] = points[0].friction_energy + points[1].friction_energy;
}

}  // namespace asperity
