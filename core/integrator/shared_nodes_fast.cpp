#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/integrator/shared_nodes_fast.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h:
#include <hwy/highway.h>

#include <algorithm>
#include <limits>

#include "core/integrator/motion_simd.inl.hpp"
#include "core/integrator/node_motion.hpp"
#include "core/integrator/platen_contact.hpp"

HWY_BEFORE_NAMESPACE();
namespace asperity::HWY_NAMESPACE {

/// Elastic constants of a batch's triangles; one set where none lies in an elastic part.
Elasticity elasticity_of(const Particles& p, unsigned bulk) {
  return bulk == 0 ? Elasticity(p.elastic) : Elasticity(p.bulk, p.elastic, lanes_of(bulk));
}

/// Which triangles of a batch lie in an elastic part, one bit each.
unsigned bulk_lanes(const Particles& p, const Batch& batch) {
  unsigned bulk = 0;
  if (p.in_bulk.empty()) return bulk;
  for (std::size_t lane = 0; lane < kLanes; ++lane) bulk |= unsigned{p.in_bulk[batch.at(lane)]} << lane;
  return bulk;
}

/// Of triangles, where those in an elastic part do not yield.
Corners forces_of(Particles& p, const Batch& batch, const Corners& x) {
  const std::size_t block = batch.first / kBlock;
  const unsigned bulk = bulk_lanes(p, batch);
  if (p.plasticity.empty()) return elastic_forces(p.shapes[block], batch, x, elasticity_of(p, bulk));
  const Real never = set(std::numeric_limits<double>::infinity());
  const Real half_yield = hn::IfThenElse(lanes_of(bulk), never, set(p.half_yield));
  return yielding_forces(p.shapes[block], p.plasticity[block], batch, x, elasticity_of(p, bulk), half_yield);
}

Points corner_points(const Particles& p, const Batch& batch, std::size_t k) {
  return load_points([&](std::size_t lane) { return &p.position[p.triangles[batch.at(lane)][k]].x; });
}

void write_corner_forces(System& system, std::size_t begin, std::size_t end) {
  Particles& p = system.particles;
  Vec2* corners = system.forces.data() + 2 * system.contacts.slot_count();
  for (std::size_t first = begin; first < end; first += kLanes) {
    const Batch batch{first, std::min(kLanes, end - first)};
    const Corners x{corner_points(p, batch, 0), corner_points(p, batch, 1), corner_points(p, batch, 2)};
    const Corners force = forces_of(p, batch, x);
    for (std::size_t k = 0; k < 3; ++k) {
      Vec2 written[kLanes];
      store_points(force[k], [&](std::size_t lane) { return &written[lane].x; });
      for (std::size_t lane = 0; lane < batch.count; ++lane) corners[3 * (first + lane) + k] = written[lane];
    }
  }
}

/// Whether a node is for the scalar code: perhaps behind a flat platen's face or just leaving it, held, or part of a
/// block.
bool is_special(const System& system, std::size_t node) {
  const double y = system.particles.position[node].y;
  return (system.platens.present && (y < system.platens.y[0] || y > lowest_of_upper_face(system.platens))) ||
         (!system.platen_shear.empty() && system.platen_shear[node] != 0.0) ||
         (!system.held.empty() && system.held[node]) || (!system.block_of.empty() && system.block_of[node] >= 0);
}

/// Special nodes and those under a load, one bit each.
unsigned special_nodes(const System& system, const Batch& batch, std::size_t& next_load) {
  const std::vector<int>& loaded = system.loads.nodes;
  unsigned special = 0;
  for (std::size_t lane = 0; lane < batch.count; ++lane) {
    const std::size_t node = batch.first + lane;
    const bool load = next_load < loaded.size() && static_cast<std::size_t>(loaded[next_load]) == node;
    next_load += load;
    special |= unsigned{load || is_special(system, node)} << lane;
  }
  return special;
}

Real masses(const std::vector<double>& mass, const Batch& batch) {
  if (HWY_LIKELY(batch.count == kLanes)) return hn::LoadU(kDoubles, &mass[batch.first]);
  HWY_ALIGN double m[kLanes];
  for (std::size_t lane = 0; lane < kLanes; ++lane) m[lane] = mass[batch.at(lane)];
  return hn::Load(kDoubles, m);
}

NodeSums move_shared_nodes(System& system, std::size_t begin, std::size_t end) {
  const Step step(system);
  const std::vector<int>& loaded = system.loads.nodes;
  std::size_t next_load = std::lower_bound(loaded.begin(), loaded.end(), static_cast<int>(begin)) - loaded.begin();
  std::vector<Vec2>& velocity = system.particles.velocity;
  LaneSums lanes;
  NodeSums sums;
  for (std::size_t first = begin; first < end; first += kLanes) {
    const Batch batch{first, std::min(kLanes, end - first)};
    Vec2 internal[kLanes] = {};
    for (std::size_t i = 0; i < batch.count; ++i) internal[i] = gather_force(system, first + i, system.forces);
    const unsigned special = special_nodes(system, batch, next_load);
    const unsigned free = ((1u << batch.count) - 1) & ~special;
    const Points force = load_points([&](std::size_t lane) { return &internal[lane].x; });
    const Points before = load_points([&](std::size_t lane) { return &velocity[batch.at(lane)].x; });
    Addends addends{hn::Zero(kDoubles), hn::Zero(kDoubles), hn::Zero(kDoubles)};
    Vec2 after[kLanes];
    store_points(move_free_nodes(before, force, masses(system.particles.mass, batch), step, addends),
                 [&](std::size_t lane) { return &after[lane].x; });
    for (std::size_t i = 0; i < batch.count; ++i) {
      if (free >> i & 1)
        velocity[first + i] = after[i];
      else
        move_node_reference(system, first + i, internal[i], sums);
    }
    add_lanes(addends, free, lanes, first % kBlock);
  }
  add_to(sums, lanes);
  return sums;
}

}  // namespace asperity::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asperity {
HWY_EXPORT(write_corner_forces);
HWY_EXPORT(move_shared_nodes);

void compute_corner_forces_fast(System& system, std::size_t begin, std::size_t end) {
  HWY_DYNAMIC_DISPATCH(write_corner_forces)(system, begin, end);
}

NodeSums move_nodes_fast(System& system, std::size_t begin, std::size_t end) {
  return HWY_DYNAMIC_DISPATCH(move_shared_nodes)(system, begin, end);
}
}  // namespace asperity
#endif
