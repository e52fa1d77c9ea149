#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/support/heaps.hpp"

using namespace asperity;

namespace {

const ParallelLoops kLoops;

/// 2,112 triangles bonded as single particles in a held box, torn apart by their velocities.
System torn_assembly(double speed, bool general) {
  const test::Grid grid{33, 32};
  test::Bodies bodies;
  test::add_box(bodies, 70.0, 20);
  const Mesh pieces = test::grid_mesh(grid);
  const int first = static_cast<int>(bodies.mesh.vertices.size());
  for (Vec2 v : pieces.vertices) bodies.mesh.vertices.push_back(v + Vec2{2.0, 2.0});
  for (std::size_t t = 0; t < pieces.triangles.size(); ++t) {
    const auto& v = pieces.triangles[t];
    bodies.mesh.triangles.push_back({first + v[0], first + v[1], first + v[2]});
    bodies.mesh.grain.push_back(1 + pieces.grain[t]);
  }
  // The bonded law's own account, without general contact, is off by 1.2e-3 at 0.3 and by 2.6e-4 at 0.15.
  System system = test::bonded_system(bodies.mesh, 0.2, general);
  test::scatter_velocities(system, speed);
  test::hold(system, 0);
  book_initial_kinetic_energy(system);
  return system;
}

}  // namespace

TEST_CASE("An assembly torn apart keeps its energy account, and is bitwise the same on 1, 2 and 4 threads") {
  std::vector<Vec2> positions, velocities;
  for (int threads : {1, 2, 4}) {
    const ParallelLoops loops(threads);
    System system = torn_assembly(2e4, true);
    test::EnergyWatch energy;
    for (int step = 0; step < 300; ++step) {
      compute_forces(system, loops);
      update_velocities(system, loops);
      if (threads == 1 && step % 10 == 0) energy.see(energy_balance(system, loops));
      update_positions(system, loops);
    }
    if (threads == 1) {
      CHECK(energy.relative() < 1e-3);
      CHECK(system.general.touches.size() > 2 * ParallelLoops::kBlock);
      CHECK(system.general.pairs.size() > 4 * ParallelLoops::kBlock);
      CHECK(test::released(system.contacts) > 50);
      WARN("energy error " << energy.relative() << ", " << system.general.touches.size() << " touches, "
                           << system.general.pairs.size() << " pairs, " << test::broken(system.contacts) << " of "
                           << system.contacts.size() << " contacts broken, " << test::released(system.contacts)
                           << " released, deepest " << system.general.largest_depth << " mm");
      positions = system.particles.position;
      velocities = system.particles.velocity;
    }
    CAPTURE(threads);
    CHECK(system.particles.position == positions);
    CHECK(system.particles.velocity == velocities);
  }
}

TEST_CASE("Without general contact an assembly moves as before it existed; with it, an unbroken one does too") {
  System without = torn_assembly(2e4, false), off = torn_assembly(2e4, true);
  off.general.law.enabled = false;
  off.contacts.hand_over_range = 0.0;
  off.time_step = without.time_step;
  test::advance(without, kLoops, 200);
  test::advance(off, kLoops, 200);
  CHECK(test::broken(without.contacts) > 1000);
  CHECK(off.particles.position == without.particles.position);
  CHECK(off.general.touches.empty());

  System still = torn_assembly(1.0, false), still_on = torn_assembly(1.0, true);
  still_on.time_step = still.time_step;
  test::advance(still, kLoops, 200);
  test::advance(still_on, kLoops, 200);
  CHECK(test::broken(still.contacts) == 0);
  CHECK(still_on.particles.position == still.particles.position);
}
