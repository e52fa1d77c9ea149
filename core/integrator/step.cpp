#include <algorithm>
#include <cmath>

#include "core/integrator/body_motion.hpp"
#include "core/integrator/flank.hpp"
#include "core/integrator/node_motion.hpp"
#include "core/integrator/system.hpp"

namespace asperity {
namespace {

ForceSlots force_slots(System& system) {
  return {system.forces, system.contacts.slot_of_edge, corners_written(system) ? 2 * system.contacts.slot_count() : 0};
}

/// All nodes' velocities, in blocks that any number of threads shares alike.
NodeSums move_nodes(System& system, const ParallelLoops& loops) {
  if (!corners_written(system)) {
    return loops.sum_blocks<NodeSums>(system.particles.triangle_count(), [&](std::size_t begin, std::size_t end) {
      return move_triangles_fast(system, begin, end);
    });
  }
  const bool plain = system.platens.jaw.radius == 0.0 && system.body_acceleration == Vec2{};
  const auto move = system.kernel == Kernel::fast && plain ? move_nodes_fast : move_nodes_reference;
  return loops.sum_blocks<NodeSums>(system.particles.node_count(),
                                    [&](std::size_t begin, std::size_t end) { return move(system, begin, end); });
}

}  // namespace

void compute_corner_forces(System& system, std::size_t begin, std::size_t end) {
  const std::size_t corners = 2 * system.contacts.slot_count();
  for (std::size_t t = begin; t < end; ++t) {
    const auto force = corner_forces(system.particles.shape(t), update_triangle(system.particles, t));
    for (std::size_t k = 0; k < 3; ++k) system.forces[corners + 3 * t + k] = force[k];
  }
}

void compute_forces(System& system, const ParallelLoops& loops) {
  const Particles& p = system.particles;
  const ForceSlots forces = force_slots(system);
  std::fill(system.forces.begin() + 2 * contact_slot_count(system.contacts.size()),
            system.forces.begin() + 2 * system.contacts.slot_count(), Vec2{});
  if (corners_written(system)) {
    const auto compute = system.kernel == Kernel::fast ? compute_corner_forces_fast : compute_corner_forces;
    loops.for_blocks(p.triangle_count(), [&](std::size_t begin, std::size_t end) { compute(system, begin, end); });
  }
  const int changes = update_contacts(system.contacts, p.position, system.time, loops, system.forces, system.kernel);
  update_general_contacts(system.general, system.contacts, p, system.time_step, loops, forces);
  if (changes > 0) system.general.search_due = 1;
  follow_outer_surface(system);
  apply_flank_pressure(system);
}

void update_velocities(System& system, const ParallelLoops& loops) {
  if (system.platens.friction > 0.0) system.platen_shear.resize(system.particles.node_count(), 0.0);
  system.external_work += system.sums.work_after + platen_work(system);
  system.damping_energy += 0.5 * system.sums.damping;
  system.sums = move_nodes(system, loops);
  move_bodies(system);
  system.external_work += system.sums.work_before + platen_work(system);
  system.damping_energy += 0.5 * system.sums.damping;
  system.platen_friction_energy += system.sums.platen_friction;
}

void update_positions(System& system, const ParallelLoops& loops) {
  Particles& p = system.particles;
  const double dt = system.time_step;
  loops.for_blocks(p.node_count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node) p.position[node] += dt * p.velocity[node];
  });
  advance_bodies(system);
  system.general.travel += dt * std::sqrt(system.sums.fastest);
  system.time += dt;
  ++system.step;
}

}  // namespace asperity
