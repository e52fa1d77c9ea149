#include "core/integrator/system.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/integrator/flank.hpp"

namespace asperity {
namespace {

/// Calls visit(node, slot) for every force contribution: triangle corners first, then the four nodes of each contact
/// edge.
template <class Visit>
void for_each_slot(const System& system, const Visit& visit) {
  int slot = 0;
  for (const auto& nodes : system.particles.triangles) {
    for (int node : nodes) visit(node, slot++);
  }
  for (const ContactEdge& e : system.contacts.edges) {
    for (int node : {e.left1, e.left2, e.right1, e.right2}) visit(node, slot++);
  }
}

void list_slots(System& system) {
  const std::size_t n = system.particles.node_count();
  system.slot_begin.assign(n + 1, 0);
  for_each_slot(system, [&](int node, int) { ++system.slot_begin[node + 1]; });
  for (std::size_t i = 0; i < n; ++i) system.slot_begin[i + 1] += system.slot_begin[i];
  system.slots.resize(system.slot_begin[n]);
  std::vector<int> fill(system.slot_begin.begin(), system.slot_begin.end() - 1);
  for_each_slot(system, [&](int node, int slot) { system.slots[fill[node]++] = slot; });
}

/// Penalty contact of one node with the platens: force on the node; energies and reactions go to sums.
Vec2 platen_force(System& system, std::size_t node, NodeSums& sums) {
  const Platens& platens = system.platens;
  const double y = system.particles.position[node].y;
  const PlatenSpring spring = system.platen_springs[node];
  const double overlap[2] = {platens.y[0] - y - spring.skin, y - platens.y[1] - spring.skin};
  const int side = overlap[0] > 0.0 ? 0 : 1;
  double& shear = system.platen_shear[node];
  if (overlap[side] <= 0.0) {
    sums.platen_friction += 0.5 * shear * shear / spring.stiffness;  // what the lost contact still held
    shear = 0.0;
    return {0, 0};
  }
  const double normal = spring.stiffness * overlap[side];
  sums.reaction[side] += normal;
  sums.platen_energy += 0.5 * normal * overlap[side];
  if (platens.friction > 0.0) {
    const double trial = shear - spring.stiffness * system.particles.velocity[node].x * system.time_step;
    const double limit = platens.friction * normal;
    const double after = std::clamp(trial, -limit, limit);
    sums.platen_friction += std::max(0.0, 0.5 * (shear + after) * (trial - after)) / spring.stiffness;
    sums.platen_energy += 0.5 * after * after / spring.stiffness;
    shear = after;
  }
  return {shear, side == 0 ? normal : -normal};
}

/// Cundall's local damping, limited so that it never turns the motion round: Eq. (I4). `impulse` is 2 m / dt. Returns
/// the damping force.
double damping_force(double force, double coefficient, double mean_velocity, double impulse) {
  const double limit = impulse * std::abs(mean_velocity);
  return -std::copysign(std::min(coefficient * std::abs(force), limit), mean_velocity);
}

void move_free_node(System& system, std::size_t node, Vec2 force, Vec2 external, NodeSums& sums) {
  const double dt = system.time_step;
  const double m = system.particles.mass[node];
  Vec2& v = system.particles.velocity[node];
  const Vec2 before = v;
  const double step = dt / m;
  const Vec2 trial = before + step * force;
  const Vec2 mean = 0.5 * (before + trial);
  const double impulse = m * (2.0 / dt);
  const Vec2 damping{damping_force(force.x, system.local_damping, mean.x, impulse),
                     damping_force(force.y, system.local_damping, mean.y, impulse)};
  v = trial + step * damping;
  sums.damping -= 0.5 * dt * dot(damping, before + v);
  sums.work_before += 0.5 * dt * dot(external, before);
  sums.work_after += 0.5 * dt * dot(external, v);
  sums.kinetic += 0.5 * m * dot(before, v);
  sums.fastest = std::max(sums.fastest, dot(v, v));
}

void move_held_node(const System& system, std::size_t node, Vec2 force, Vec2 external, NodeSums& sums) {
  const Vec2 v = system.particles.velocity[node];
  const double half_step_work = 0.5 * system.time_step * dot(external - force, v);
  sums.work_before += half_step_work;
  sums.work_after += half_step_work;
  sums.kinetic += 0.5 * system.particles.mass[node] * dot(v, v);
  sums.fastest = std::max(sums.fastest, dot(v, v));
}

NodeSums update_node_range(System& system, std::size_t begin, std::size_t end) {
  NodeSums sums;
  for (std::size_t node = begin; node < end; ++node) {
    const Vec2 external = system.external_force[node] + system.particles.mass[node] * system.body_acceleration;
    Vec2 force = internal_force(system, node) + external;
    if (system.platens.present) force += platen_force(system, node, sums);
    if (!system.held.empty() && system.held[node]) {
      move_held_node(system, node, force, external, sums);
    } else {
      move_free_node(system, node, force, external, sums);
    }
  }
  return sums;
}

/// Work of the platens on the specimen over half a step at the given velocities.
double platen_work(const NodeSums& sums, const std::array<double, 2>& velocity, double dt) {
  return 0.5 * dt * (sums.reaction[0] * velocity[0] - sums.reaction[1] * velocity[1]);
}

}  // namespace

NodeSums& NodeSums::operator+=(const NodeSums& o) {
  for (int i = 0; i < 2; ++i) reaction[i] += o.reaction[i];
  work_before += o.work_before;
  work_after += o.work_after;
  damping += o.damping;
  platen_friction += o.platen_friction;
  platen_energy += o.platen_energy;
  kinetic += o.kinetic;
  fastest = std::max(fastest, o.fastest);
  return *this;
}

void prepare(System& system) {
  const std::size_t nodes = system.particles.node_count();
  list_slots(system);
  system.forces.assign(3 * system.particles.triangle_count() + 4 * system.contacts.size(), {});
  system.external_force.assign(nodes, {});
  system.platen_shear.assign(nodes, 0.0);
}

void compute_forces(System& system, const ParallelLoops& loops) {
  const Particles& p = system.particles;
  loops.for_blocks(p.triangle_count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const BiotState state = biot_state(deformation_gradient(p.shapes[t], p.corners(t)), p.elastic);
      const auto force = corner_forces(p.shapes[t], state);
      for (std::size_t i = 0; i < 3; ++i) system.forces[3 * t + i] = force[i];
    }
  });
  const auto triangle_forces = std::span(system.forces).first(3 * p.triangle_count());
  const auto contact_forces = std::span(system.forces).subspan(3 * p.triangle_count());
  const int changes = update_contacts(system.contacts, p.position, system.time, loops, contact_forces);
  update_general_contacts(system.general, system.contacts, p, system.time_step, loops, triangle_forces, contact_forces);
  if (changes > 0) system.general.search_due = 1;
  follow_outer_surface(system);
  apply_flank_pressure(system);
}

Vec2 internal_force(const System& system, std::size_t node) {
  Vec2 force;
  for (int i = system.slot_begin[node]; i < system.slot_begin[node + 1]; ++i) force += system.forces[system.slots[i]];
  return force;
}

void update_velocities(System& system, const ParallelLoops& loops) {
  system.external_work +=
      system.sums.work_after + platen_work(system.sums, system.platens.last_velocity, system.time_step);
  system.damping_energy += 0.5 * system.sums.damping;
  system.sums = loops.sum_blocks<NodeSums>(system.particles.node_count(), [&](std::size_t begin, std::size_t end) {
    return update_node_range(system, begin, end);
  });
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

double elastic_energy(const Particles& particles, const ParallelLoops& loops) {
  return loops.sum_blocks<double>(particles.triangle_count(), [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t t = begin; t < end; ++t) sum += triangle_energy(particles, t);
    return sum;
  });
}

EnergyBalance energy_balance(const System& system, const ParallelLoops& loops) {
  const ContactEnergies contacts = contact_energies(system.contacts, loops);
  const GeneralContactEnergies general = general_contact_energies(system.general, loops);
  EnergyBalance e;
  e.external_work = system.external_work + system.initial_kinetic;
  e.elastic = elastic_energy(system.particles, loops);
  e.recoverable = contacts.recoverable + general.normal + general.tangential + system.sums.platen_energy;
  e.fracture = contacts.fracture;
  e.friction = contacts.friction + system.general.friction_energy + system.platen_friction_energy;
  e.damping = system.damping_energy + system.general.damping_energy;
  e.kinetic = system.sums.kinetic;
  e.created_by_law = contacts.created;
  return e;
}

void book_initial_kinetic_energy(System& system) {
  for (std::size_t i = 0; i < system.particles.node_count(); ++i) {
    const Vec2 v = system.particles.velocity[i];
    system.initial_kinetic += 0.5 * system.particles.mass[i] * dot(v, v);
  }
}

}  // namespace asperity
