#include <catch2/catch.hpp>
#include <cmath>

#include "core/integrator/static_stiffness.hpp"
#include "tests/support/models.hpp"

using namespace asperity;

namespace {

const ParallelLoops kLoops;

/// 8 x 8 mm between platens, or jaws that its corners touch, which press its ends by 0.001 mm.
System pressed_square(const JawFace& jaw = {}) {
  System system = test::make_system(test::grid_mesh({4, 4}), test::plaster(), test::unbreakable_law());
  system.platens.present = true;
  system.platens.y = {0.001, 7.999};
  if (jaw.radius > 0.0) {
    system.platens.jaw = jaw;
    system.platens.y = {0.001 - jaw.depth, 7.999 + jaw.depth};
  }
  system.platen_springs.other = {1000.0, 0.0};
  return system;
}

std::vector<EdgeStiffness> initial_stiffness(const BondedContacts& contacts) {
  const PointStiffness point{contacts.law.k_t, contacts.law.k_s};
  return std::vector<EdgeStiffness>(contacts.size(), {point, point});
}

double largest(const std::vector<Vec2>& force) {
  double size = 0.0;
  for (Vec2 f : force) size = std::max(size, norm(f));
  return size;
}

}  // namespace

TEST_CASE("platen loads, the nodes they press and the forces on them agree") {
  System system = pressed_square();
  compute_forces(system, kLoops);
  const PlatenLoad load = platen_load(system);
  const std::vector<std::uint8_t> pressed = nodes_on_platens(system);
  double energy = 0.0, sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < pressed.size(); ++i) {
    const double y = system.particles.reference(i).y;
    CHECK(pressed[i] == (y == 0.0 || y == 8.0));
    count += pressed[i];
    if (pressed[i]) energy += 0.5 * 1000.0 * 0.001 * 0.001;
    sum += std::abs(out_of_balance(system)[i].y);
  }
  CHECK(load.reaction[0] + load.reaction[1] == Approx(count * 1.0));
  CHECK(load.energy == Approx(energy));
  CHECK(sum == Approx(count * 1.0));  // nothing else acts yet
}

TEST_CASE("between jaws the loads are those of a step, and push the corners inwards") {
  const double depth = 10.0 - std::sqrt(100.0 - 4.0 * 4.0);
  System system = pressed_square({10.0, 4.0, 4.0, depth});
  compute_forces(system, kLoops);
  const PlatenLoad load = platen_load(system);
  update_velocities(system, kLoops);
  CHECK(load.reaction[0] > 0.0);
  CHECK(load.reaction[0] == Approx(system.sums.reaction[0]));
  CHECK(load.reaction[1] == Approx(system.sums.reaction[1]));
  CHECK(load.energy == Approx(system.sums.platen_energy));
  double upwards = 0.0, aside = 0.0;
  for (Vec2 f : out_of_balance(system)) {
    upwards += f.y;
    aside += std::abs(f.x);
  }
  CHECK(aside > 0.1 * load.reaction[0]);
  CHECK(upwards == Approx(load.reaction[0] - load.reaction[1]).margin(1e-12));
}

TEST_CASE("between jaws the stiffness is the derivative of the platens' forces") {
  const double depth = 10.0 - std::sqrt(100.0 - 4.0 * 4.0);
  System system = pressed_square({10.0, 4.0, 4.0, depth});
  for (double& y : system.platens.y) y += y < 4.0 ? 0.2 : -0.2;  // deep, so that the turning of the normal counts
  compute_forces(system, kLoops);
  const StaticStiffness pressed(system, initial_stiffness(system.contacts));
  const std::vector<Vec2> before = out_of_balance(system);
  std::vector<Vec2> force(before.size());  // on one corner of the bottom alone, aside and up
  std::size_t corner = 0;
  while (system.particles.reference(corner).x != 0.0 || system.particles.reference(corner).y != 0.0) ++corner;
  force[corner] = {1e-3, 2e-3};
  const std::vector<Vec2> u = pressed.solve(force);
  for (std::size_t i = 0; i < u.size(); ++i) system.particles.position[i] += u[i];
  compute_forces(system, kLoops);
  const std::vector<Vec2> after = out_of_balance(system);
  for (std::size_t i = 0; i < u.size(); ++i) {  // the change balances the force, to second order and the hold of 1e-7
    CHECK(norm(after[i] - before[i] + force[i]) < 2e-2 * norm(force[corner]));
  }
}

TEST_CASE("a static solution balances small forces") {
  System system = pressed_square();
  compute_forces(system, kLoops);
  const double before = largest(out_of_balance(system));
  const StaticStiffness stiffness(system, initial_stiffness(system.contacts));
  for (int iteration = 0; iteration < 3; ++iteration) {
    const std::vector<Vec2> u = stiffness.solve(out_of_balance(system));
    for (std::size_t i = 0; i < u.size(); ++i) system.particles.position[i] += u[i];
    compute_forces(system, kLoops);
  }
  CHECK(largest(out_of_balance(system)) < 1e-8 * before);
  const PlatenLoad load = platen_load(system);
  CHECK(load.reaction[0] == Approx(load.reaction[1]));
  CHECK(load.reaction[0] > 0.0);
}

TEST_CASE("a body that the platens do not touch cannot balance their load, but its motion stays finite") {
  System system = pressed_square();
  system.platens.y = {-1.0, 9.0};
  compute_forces(system, kLoops);
  const StaticStiffness stiffness(system, initial_stiffness(system.contacts));
  std::vector<Vec2> force(system.particles.node_count());
  force[0].x = 1.0;
  CHECK(std::isfinite(largest(stiffness.solve(force))));
}
