#include "core/integrator/body_motion.hpp"

#include <algorithm>
#include <cmath>

#include "core/integrator/node_motion.hpp"
#include "core/integrator/platen_contact.hpp"

namespace asperity {
namespace {

/// Velocity of a body half a step ahead under a force, Eqs. (I1) and (I4), with the nodes' local damping. Returns the
/// damping force.
double push(const System& system, double& velocity, double mass, double force) {
  const double dt = system.time_step, before = velocity, trial = before + dt / mass * force;
  const double damping = damping_force(force, system.local_damping, 0.5 * (before + trial), mass * (2.0 / dt));
  velocity = trial + dt / mass * damping;
  return damping;
}

/// The same for a block under its nodes' force and a load, whose work is external; Eq. (I22).
void push_block(System& system, double& velocity, double mass, double reaction, double load) {
  const double dt = system.time_step, before = velocity;
  const double damping = push(system, velocity, mass, reaction + load);
  system.sums.damping -= 0.5 * dt * damping * (before + velocity);
  system.sums.work_before += 0.5 * dt * load * before;
  system.sums.work_after += 0.5 * dt * load * velocity;
}

/// The work of what gives a driven block its velocity, Eq. (I23).
void book_drive(System& system, const RigidBlock& block) {
  const double dt = system.time_step;
  const Vec2 before = block.last_velocity, after = block.velocity;
  const Vec2 drive = (block.mass / dt) * (after - before) - block.reaction;
  system.sums.work_before += 0.5 * dt * dot(drive, before);
  system.sums.work_after += 0.5 * dt * dot(drive, after);
}

Vec2 turned(Vec2 arm, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * arm.x - s * arm.y, s * arm.x + c * arm.y};
}

/// The moment of the forces on a block's nodes about the middles it turns about.
double moment_on(const System& system, const RigidBlock& block) {
  double moment = 0.0;
  for (std::size_t i = 0; i < block.nodes.size(); ++i) {
    const auto node = static_cast<std::size_t>(block.nodes[i]);
    moment += cross(turned(block.turn.arms[i], block.turn.angle), internal_force(system, node) + system.loads.at(node));
  }
  return moment;
}

/// Eq. (I26).
void turn_block(System& system, RigidBlock& block) {
  BlockTurn& turn = block.turn;
  turn.last_rate = turn.rate;
  push_block(system, turn.rate, turn.inertia, moment_on(system, block), -turn.stiffness * turn.angle);
  system.sums.kinetic += 0.5 * turn.inertia * turn.last_rate * turn.rate;
}

/// The nodes of a block that turns: from their places on the body to those a step ahead.
void carry_nodes(System& system, const RigidBlock& block) {
  const BlockTurn& turn = block.turn;
  const double dt = system.time_step, ahead = turn.angle + dt * turn.rate;
  for (std::size_t i = 0; i < block.nodes.size(); ++i) {
    const Vec2 spin = (1.0 / dt) * (turned(turn.arms[i], ahead) - turned(turn.arms[i], turn.angle));
    const Vec2 velocity = block.velocity + spin;
    system.particles.velocity[block.nodes[i]] = velocity;
    system.sums.fastest = std::max(system.sums.fastest, dot(velocity, velocity));
  }
}

/// Eqs. (I21)-(I23), (I26): a block takes the forces on its nodes and gives them its velocity.
void move_block(System& system, std::size_t index) {
  RigidBlock& block = system.blocks[index];
  block.reaction = system.sums.on_blocks[index];
  DriveLine& line = system.lines[0];
  if (block.free_along_y) {
    block.last_velocity = block.velocity;
    push_block(system, block.velocity.y, block.mass, block.reaction.y, block.load);
  } else if (line.tied) {
    block.last_velocity = block.velocity;
    push_block(system, block.velocity.x, block.mass, block.reaction.x, pull(line) + line.preload);
  } else {
    book_drive(system, block);
  }
  system.sums.kinetic += 0.5 * block.mass * dot(block.last_velocity, block.velocity);
  system.sums.fastest = std::max(system.sums.fastest, dot(block.velocity, block.velocity));
  if (!block.turn.arms.empty()) {
    turn_block(system, block);
    return carry_nodes(system, block);
  }
  for (int node : block.nodes) system.particles.velocity[node] = block.velocity;
}

/// A platen on its drive line: it has a mass of its own, outside the energy account, which ends at its face.
void move_platen(System& system, int side) {
  DriveLine& line = system.lines[side];
  if (!line.tied) return;
  double inwards = facing(side) * system.platens.velocity[side];
  push(system, inwards, line.mass, pull(line) + line.preload - system.sums.reaction[side]);
  system.platens.velocity[side] = facing(side) * inwards;
}

/// Eq. (I25).
void turn_face(System& system) {
  FaceTurn& turn = system.platens.upper;
  if (turn.inertia > 0.0) push(system, turn.rate, turn.inertia, system.sums.turning);
}

}  // namespace

void move_bodies(System& system) {
  for (std::size_t b = 0; b < system.blocks.size(); ++b) move_block(system, b);
  if (!system.platens.present) return;
  for (int side = 0; side < 2; ++side) move_platen(system, side);
  turn_face(system);
}

void advance_bodies(System& system) {
  const double dt = system.time_step;
  Platens& platens = system.platens;
  for (int i = 0; i < 2; ++i) platens.y[i] += dt * platens.velocity[i];
  platens.last_velocity = platens.velocity;
  platens.upper.slope += dt * platens.upper.rate;
  platens.upper.last_rate = platens.upper.rate;
  for (int i = 0; i < 2; ++i) {
    if (!system.lines[i].tied) continue;
    const double body = platens.present ? facing(i) * platens.velocity[i] : system.blocks[i].velocity.x;
    advance_line(system.lines[i], body, dt);
  }
  for (RigidBlock& block : system.blocks) {
    block.displacement += dt * block.velocity;
    block.last_velocity = block.velocity;
    block.turn.angle += dt * block.turn.rate;
    block.turn.last_rate = block.turn.rate;
  }
}

double platen_work(const System& system) {
  const NodeSums& sums = system.sums;
  const std::array<double, 2>& velocity = system.platens.last_velocity;
  const double work = 0.5 * system.time_step * (sums.reaction[0] * velocity[0] - sums.reaction[1] * velocity[1]);
  if (system.platens.upper.inertia == 0.0) return work;
  return work - 0.5 * system.time_step * sums.turning * system.platens.upper.last_rate;
}

}  // namespace asperity
