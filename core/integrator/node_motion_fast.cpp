#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/integrator/node_motion_fast.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h:
#include <hwy/highway.h>

#include <algorithm>

#include "core/integrator/motion_simd.inl.hpp"
#include "core/integrator/node_motion.hpp"
#include "core/integrator/platen_contact.hpp"

HWY_BEFORE_NAMESPACE();
namespace asperity::HWY_NAMESPACE {

/// The system's arrays by their addresses: the compiler must take vectors for changed after every store of points.
struct Arrays {
  const Vec2 *position, *forces;
  Vec2* velocity;
  const double* mass;
  const int* slot_of_edge;
  const PackedShapes* shapes;
  PackedPlasticity* plasticity;  ///< nullptr: particles do not yield.
  Real half_yield;
  Elasticity elastic;
  explicit Arrays(System& s)
      : position(s.particles.position.data()),
        forces(s.forces.data()),
        velocity(s.particles.velocity.data()),
        mass(s.particles.mass.data()),
        slot_of_edge(s.contacts.slot_of_edge.data()),
        shapes(s.particles.shapes.data()),
        plasticity(s.particles.plasticity.empty() ? nullptr : s.particles.plasticity.data()),
        half_yield(set(s.particles.half_yield)),
        elastic(s.particles.elastic) {}
};

HWY_INLINE Points load_corner(const Vec2* x, const Batch& batch, std::size_t k) {
  return load_points([&](std::size_t lane) { return &x[3 * batch.at(lane) + k].x; });
}

/// Forces in the slots of the triangles' edges k, on their first or second ends.
HWY_INLINE Points slot_forces(const Arrays& a, const Batch& batch, std::size_t k, std::size_t end) {
  return load_points([&](std::size_t lane) { return &a.forces[2 * a.slot_of_edge[3 * batch.at(lane) + k] + end].x; });
}

/// Masses of the three corners.
HWY_INLINE std::array<Real, 3> load_masses(const double* mass, const Batch& batch) {
  std::array<Real, 3> m;
  if (HWY_LIKELY(batch.count == kLanes)) {
    hn::LoadInterleaved3(kDoubles, &mass[3 * batch.first], m[0], m[1], m[2]);
    return m;
  }
  HWY_ALIGN double corner[kLanes];
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) corner[lane] = mass[3 * batch.at(lane) + k];
    m[k] = hn::Load(kDoubles, corner);
  }
  return m;
}

/// Lanes with a corner that may be behind a flat platen's face.
HWY_INLINE hn::Mask<Doubles> behind_platens(const Platens& platens, const Corners& x) {
  const Real low = hn::Min(hn::Min(x[0].y, x[1].y), x[2].y), high = hn::Max(hn::Max(x[0].y, x[1].y), x[2].y);
  return hn::Or(hn::Lt(low, set(platens.y[0])), hn::Gt(high, set(lowest_of_upper_face(platens))));
}

/// Lanes with a corner behind a jaw's face, Eq. (I20), or so little before it that rounding could tell otherwise.
hn::Mask<Doubles> behind_jaws(const Platens& platens, const Corners& x) {
  constexpr double kRounding = 1e-9;  // of the radius
  const JawFace& jaw = platens.jaw;
  const double inner = (1.0 - kRounding) * jaw.radius, level = jaw.depth + kRounding * jaw.radius;
  hn::Mask<Doubles> behind = hn::Lt(set(0.0), set(0.0));
  for (std::size_t side = 0; side < 2; ++side) {
    const Real up = set(side == 0 ? 1.0 : -1.0);
    for (const Points& corner : x) {
      const Real above = Mul(up, Sub(corner.y, set(platens.y[side])));
      const Points arm{Sub(corner.x, set(jaw.centre_x)), Sub(above, set(jaw.radius))};
      behind = hn::Or(behind, hn::And(hn::Gt(dot(arm, arm), set(inner * inner)), hn::Lt(above, set(level))));
    }
  }
  return behind;
}

/// Lanes that a node beyond a platen's face, a load or a held node takes out of the vector kernel, one bit each.
unsigned special_lanes(const System& system, const Batch& batch, const Corners& x, std::size_t& next_load) {
  const unsigned all = (1u << batch.count) - 1;
  if (system.body_acceleration != Vec2{}) return all;
  unsigned special = 0;
  if (system.platens.present) {
    const bool flat = system.platens.jaw.radius == 0.0;
    const auto beyond = flat ? behind_platens(system.platens, x) : behind_jaws(system.platens, x);
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(kDoubles, beyond, bits);
    special |= bits[0];
  }
  const std::vector<int>& loaded = system.loads.nodes;
  const int end = static_cast<int>(3 * (batch.first + batch.count));
  for (; next_load < loaded.size() && loaded[next_load] < end; ++next_load) {
    special |= 1u << (static_cast<std::size_t>(loaded[next_load]) / 3 - batch.first);
  }
  if (!system.platen_shear.empty()) {  // one that has just left the platen must let go
    for (std::size_t i = 0; i < 3 * batch.count; ++i) {
      special |= static_cast<unsigned>(system.platen_shear[3 * batch.first + i] != 0.0) << i / 3;
    }
  }
  if (!system.held.empty()) {
    for (std::size_t i = 0; i < 3 * batch.count; ++i) special |= unsigned{system.held[3 * batch.first + i]} << i / 3;
  }
  return special & all;
}

/// Writes a corner's points of the lanes in `bits` back.
HWY_INLINE void store_corner(const Points& points, Vec2* x, const Batch& batch, std::size_t k, unsigned bits) {
  if (HWY_LIKELY(bits == kAllLanes)) {
    store_points(points, [&](std::size_t lane) { return &x[3 * (batch.first + lane) + k].x; });
    return;
  }
  Vec2 kept[kLanes];
  store_points(points, [&](std::size_t lane) { return &kept[lane].x; });
  for (std::size_t lane = 0; lane < batch.count; ++lane) {
    if (bits >> lane & 1) x[3 * (batch.first + lane) + k] = kept[lane];
  }
}

/// The special lanes' triangles, node by node.
void move_special(System& system, const Batch& batch, unsigned special, const Corners& force, NodeSums& sums) {
  std::array<std::array<Vec2, 3>, kLanes> internal;
  for (std::size_t k = 0; k < 3; ++k) {
    store_points(force[k], [&](std::size_t lane) { return &internal[lane][k].x; });
  }
  for (std::size_t lane = 0; lane < batch.count; ++lane) {
    if (special >> lane & 1) move_triangle_reference(system, batch.first + lane, internal[lane], sums);
  }
}

HWY_INLINE void move_batch(System& system, const Arrays& arrays, const Batch& batch, const Step& step,
                           std::size_t& next_load, LaneSums& lane_sums, NodeSums& sums) {
  const Corners x{load_corner(arrays.position, batch, 0), load_corner(arrays.position, batch, 1),
                  load_corner(arrays.position, batch, 2)};
  const PackedShapes& shape = arrays.shapes[batch.first / kBlock];
  Corners force = arrays.plasticity ? yielding_forces(shape, arrays.plasticity[batch.first / kBlock], batch, x,
                                                      arrays.elastic, arrays.half_yield)
                                    : elastic_forces(shape, batch, x, arrays.elastic);
  for (std::size_t k = 0; k < 3; ++k) {
    force[k] = (force[k] + slot_forces(arrays, batch, k, 0)) + slot_forces(arrays, batch, (k + 2) % 3, 1);
  }
  const unsigned special = special_lanes(system, batch, x, next_load);
  const unsigned free = ((1u << batch.count) - 1) & ~special;
  const std::array<Real, 3> mass = load_masses(arrays.mass, batch);
  Addends addends{hn::Zero(kDoubles), hn::Zero(kDoubles), hn::Zero(kDoubles)};
  for (std::size_t k = 0; k < 3; ++k) {
    const Points before = load_corner(arrays.velocity, batch, k);
    store_corner(move_free_nodes(before, force[k], mass[k], step, addends), arrays.velocity, batch, k, free);
  }
  add_lanes(addends, free, lane_sums, batch.first % kBlock);
  if (special) move_special(system, batch, special, force, sums);
}

NodeSums move_triangles(System& system, std::size_t begin, std::size_t end) {
  const Step step(system);
  const Arrays arrays(system);
  const std::vector<int>& loaded = system.loads.nodes;
  std::size_t next_load = std::lower_bound(loaded.begin(), loaded.end(), static_cast<int>(3 * begin)) - loaded.begin();
  LaneSums lanes;
  NodeSums sums;
  for (std::size_t first = begin; first < end; first += kLanes) {
    move_batch(system, arrays, {first, std::min(kLanes, end - first)}, step, next_load, lanes, sums);
  }
  add_to(sums, lanes);
  return sums;
}

}  // namespace asperity::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asperity {
HWY_EXPORT(move_triangles);

NodeSums move_triangles_fast(System& system, std::size_t begin, std::size_t end) {
  return HWY_DYNAMIC_DISPATCH(move_triangles)(system, begin, end);
}
}  // namespace asperity
#endif
