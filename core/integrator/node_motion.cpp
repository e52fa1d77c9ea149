#include "core/integrator/node_motion.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

/// A platen contact is lost: what its friction still held is spent.
void let_go(double& shear, double stiffness, NodeSums& sums) {
  sums.platen_friction += 0.5 * shear * shear / stiffness;
  shear = 0.0;
}

/// Penalty contact of one node with the platens: force on the node; energies and reactions go to sums.
Vec2 platen_force(System& system, std::size_t node, NodeSums& sums) {
  const Platens& platens = system.platens;
  const double y = system.particles.position[node].y;
  const PlatenSpring spring = system.platen_springs.at(node);
  const double overlap[2] = {platens.y[0] - y - spring.skin, y - platens.y[1] - spring.skin};
  const int side = overlap[0] > 0.0 ? 0 : 1;
  const bool rough = platens.friction > 0.0;
  if (overlap[side] <= 0.0) {
    if (rough) let_go(system.platen_shear[node], spring.stiffness, sums);
    return {0, 0};
  }
  const double normal = spring.stiffness * overlap[side];
  sums.reaction[side] += normal;
  sums.platen_energy += 0.5 * normal * overlap[side];
  if (rough) {
    double& shear = system.platen_shear[node];
    const double trial = shear - spring.stiffness * system.particles.velocity[node].x * system.time_step;
    const double limit = platens.friction * normal;
    const double after = std::clamp(trial, -limit, limit);
    sums.platen_friction += std::max(0.0, 0.5 * (shear + after) * (trial - after)) / spring.stiffness;
    sums.platen_energy += 0.5 * after * after / spring.stiffness;
    shear = after;
  }
  return {rough ? system.platen_shear[node] : 0.0, side == 0 ? normal : -normal};
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

}  // namespace

void move_node(System& system, std::size_t node, Vec2 internal, NodeSums& sums) {
  const Vec2 external = system.loads.at(node) + system.particles.mass[node] * system.body_acceleration;
  Vec2 force = internal + external;
  if (system.platens.present) force += platen_force(system, node, sums);
  if (!system.held.empty() && system.held[node]) {
    move_held_node(system, node, force, external, sums);
  } else {
    move_free_node(system, node, force, external, sums);
  }
}

}  // namespace asperity
