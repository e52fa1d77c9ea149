#include "core/integrator/node_motion.hpp"

#include <algorithm>
#include <cmath>

#include "core/integrator/platen_contact.hpp"

namespace asperity {

double damping_force(double force, double coefficient, double mean_velocity, double impulse) {
  const double limit = impulse * std::abs(mean_velocity);
  return -std::copysign(std::min(coefficient * std::abs(force), limit), mean_velocity);
}

namespace {

/// A platen contact is lost, or there was none: what its friction still held is spent.
void let_go(System& system, std::size_t node, NodeSums& sums) {
  if (system.platens.friction == 0.0 || system.platen_shear[node] == 0.0) return;
  double& shear = system.platen_shear[node];
  sums.platen_friction += 0.5 * shear * shear / system.platen_springs.at(node).stiffness;
  shear = 0.0;
}

/// Friction along the face under a normal force, after the last step's slip; Eq. (I6).
double platen_shear(System& system, std::size_t node, const PlatenContact& contact, double normal, NodeSums& sums) {
  const Platens& platens = system.platens;
  const double stiffness = contact.spring.stiffness;
  const Vec2 relative = system.particles.velocity[node] - Vec2{0.0, platens.last_velocity[contact.side]};
  const double slip_rate = dot(relative, along_face(contact.touch, contact.side));
  double& shear = system.platen_shear[node];
  const double trial = shear - stiffness * slip_rate * system.time_step;
  const double limit = platens.friction * normal;
  const double after = std::clamp(trial, -limit, limit);
  sums.platen_friction += std::max(0.0, 0.5 * (shear + after) * (trial - after)) / stiffness;
  sums.platen_energy += 0.5 * after * after / stiffness;
  shear = after;
  return after;
}

/// Penalty contact of one node with the platens: force on the node; energies and reactions go to sums.
Vec2 platen_force(System& system, std::size_t node, NodeSums& sums) {
  const PlatenContact contact = platen_contact(system, node);
  if (contact.overlap <= 0.0) {
    let_go(system, node, sums);
    return {0, 0};
  }
  const double normal = contact.spring.stiffness * contact.overlap;
  sums.platen_energy += 0.5 * normal * contact.overlap;
  Vec2 force = normal * contact.touch.normal;
  if (system.platens.friction > 0.0) {
    force += platen_shear(system, node, contact, normal, sums) * along_face(contact.touch, contact.side);
  }
  sums.reaction[contact.side] += facing(contact.side) * force.y;
  const FaceTurn& upper = system.platens.upper;
  if (contact.side == 1 && upper.inertia > 0.0) {
    sums.turning -= force.y * (system.particles.reference(node).x - upper.pivot_x);
  }
  return force;
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

/// Velocity of a node half a step ahead under the force (N per mm of thickness) of triangles and contacts, Eqs.
/// (I1)-(I6); what the energy account needs goes to sums.
void move_node(System& system, std::size_t node, Vec2 internal, NodeSums& sums) {
  const Vec2 load = system.loads.nodes.empty() ? Vec2{} : system.loads.at(node);
  const Vec2 external = load + system.particles.mass[node] * system.body_acceleration;
  Vec2 force = internal + external;
  if (system.platens.present) force += platen_force(system, node, sums);
  if (!system.block_of.empty() && system.block_of[node] >= 0) {
    sums.on_blocks[system.block_of[node]] += force;
  } else if (!system.held.empty() && system.held[node]) {
    move_held_node(system, node, force, external, sums);
  } else {
    move_free_node(system, node, force, external, sums);
  }
}

}  // namespace

void move_node_reference(System& system, std::size_t node, Vec2 internal, NodeSums& sums) {
  move_node(system, node, internal, sums);
}

NodeSums move_nodes_reference(System& system, std::size_t begin, std::size_t end) {
  NodeSums sums;
  for (std::size_t node = begin; node < end; ++node) {
    move_node(system, node, gather_force(system, node, system.forces), sums);
  }
  return sums;
}

void move_triangle_reference(System& system, std::size_t triangle, const std::array<Vec2, 3>& internal,
                             NodeSums& sums) {
  for (std::size_t k = 0; k < 3; ++k) move_node(system, 3 * triangle + k, internal[k], sums);
}

}  // namespace asperity
