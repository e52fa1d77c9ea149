#include <algorithm>
#include <cmath>

#include "core/integrator/flank.hpp"
#include "core/integrator/node_motion.hpp"
#include "core/integrator/system.hpp"

namespace asperity {
namespace {

ForceSlots force_slots(System& system) {
  return {system.forces, system.contacts.slot_of_edge, corners_written(system) ? 2 * system.contacts.slot_count() : 0};
}

/// Work of the platens on the specimen over half a step at the given velocities.
double platen_work(const NodeSums& sums, const std::array<double, 2>& velocity, double dt) {
  return 0.5 * dt * (sums.reaction[0] * velocity[0] - sums.reaction[1] * velocity[1]);
}

/// All nodes' velocities, in blocks that any number of threads shares alike.
NodeSums move_nodes(System& system, const ParallelLoops& loops) {
  if (!corners_written(system)) {
    return loops.sum_blocks<NodeSums>(system.particles.triangle_count(), [&](std::size_t begin, std::size_t end) {
      return move_triangles_fast(system, begin, end);
    });
  }
  return loops.sum_blocks<NodeSums>(system.particles.node_count(), [&](std::size_t begin, std::size_t end) {
    return move_nodes_reference(system, begin, end);
  });
}

}  // namespace

void compute_corner_forces(System& system, std::size_t begin, std::size_t end) {
  const Particles& p = system.particles;
  const std::size_t corners = 2 * system.contacts.slot_count();
  for (std::size_t t = begin; t < end; ++t) {
    const TriangleShape shape = p.shape(t);
    const auto force = corner_forces(shape, biot_state(deformation_gradient(shape, p.corners(t)), p.elastic));
    for (std::size_t k = 0; k < 3; ++k) system.forces[corners + 3 * t + k] = force[k];
  }
}

void compute_forces(System& system, const ParallelLoops& loops) {
  const Particles& p = system.particles;
  const ForceSlots forces = force_slots(system);
  std::fill(system.forces.begin() + 2 * contact_slot_count(system.contacts.size()),
            system.forces.begin() + 2 * system.contacts.slot_count(), Vec2{});
  if (corners_written(system)) {
    loops.for_blocks(p.triangle_count(),
                     [&](std::size_t begin, std::size_t end) { compute_corner_forces(system, begin, end); });
  }
  const int changes = update_contacts(system.contacts, p.position, system.time, loops, system.forces, system.kernel);
  update_general_contacts(system.general, system.contacts, p, system.time_step, loops, forces);
  if (changes > 0) system.general.search_due = 1;
  follow_outer_surface(system);
  apply_flank_pressure(system);
}

void update_velocities(System& system, const ParallelLoops& loops) {
  if (system.platens.friction > 0.0) system.platen_shear.resize(system.particles.node_count(), 0.0);
  system.external_work +=
      system.sums.work_after + platen_work(system.sums, system.platens.last_velocity, system.time_step);
  system.damping_energy += 0.5 * system.sums.damping;
  system.sums = move_nodes(system, loops);
  system.external_work +=
      system.sums.work_before + platen_work(system.sums, system.platens.last_velocity, system.time_step);
  system.damping_energy += 0.5 * system.sums.damping;
  system.platen_friction_energy += system.sums.platen_friction;
}

void update_positions(System& system, const ParallelLoops& loops) {
  Particles& p = system.particles;
  const double dt = system.time_step;
  loops.for_blocks(p.node_count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node) p.position[node] += dt * p.velocity[node];
  });
  for (int i = 0; i < 2; ++i) system.platens.y[i] += dt * system.platens.velocity[i];
  system.platens.last_velocity = system.platens.velocity;
  system.general.travel += dt * std::sqrt(system.sums.fastest);
  system.time += dt;
  ++system.step;
}

}  // namespace asperity
