#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "core/base/error.hpp"
#include "core/integrator/guards.hpp"
#include "core/integrator/time_step.hpp"
#include "tests/support/models.hpp"

using namespace asperity;

namespace {

const ParallelLoops kLoops;

/// Largest energy, over the first, of an undamped free vibration at a multiple of the critical step.
double energy_growth(double multiple) {
  System system = test::make_system(test::grid_mesh({4, 4}), test::plaster(), test::unbreakable_law());
  system.time_step *= 2.0 * multiple;  // make_system takes half the critical step
  test::scatter_velocities(system, 1e-3);
  book_initial_kinetic_energy(system);
  double largest = 0.0;
  for (int i = 0; i < 2000 && largest < 1e6; ++i) {
    const EnergyBalance e = test::advance_with_energy(system, kLoops);
    largest = std::max(largest, (std::abs(e.kinetic) + e.elastic + e.recoverable) / system.initial_kinetic);
  }
  return largest;
}

}  // namespace

TEST_CASE("the critical time step divides stable from unstable motion") {
  CHECK(energy_growth(0.97) < 50.0);  // near the limit the leapfrog's energy swings, but stays bounded
  CHECK(energy_growth(1.03) > 1e6);
}

TEST_CASE("the critical time step grows with the square root of the mass") {
  System system = test::make_system(test::grid_mesh({4, 4}));
  const double before = critical_time_step(system, kLoops);
  for (double& m : system.particles.mass) m *= 4.0;
  CHECK(critical_time_step(system, kLoops) ==
        Approx(2.0 * before).epsilon(1e-4));  // the iteration's own tolerance: 1e-5
}

TEST_CASE("mass scaling makes the asked step stable and touches no node that needs nothing") {
  System system = test::make_system(test::grid_mesh({6, 6}));
  const std::vector<double> mass = system.particles.mass;
  const double before = critical_time_step(system, kLoops);
  CHECK(scale_masses(system, 1e-3 * before, 0.7) == 0.0);
  CHECK(system.particles.mass == mass);
  const double asked = 2.0 * before;
  const double added = scale_masses(system, asked, 0.7);
  CHECK(added > 0.0);
  CHECK(critical_time_step(system, kLoops) >= asked / 0.7);  // Gershgorin's bound is on the safe side
  for (std::size_t i = 0; i < mass.size(); ++i) CHECK(system.particles.mass[i] >= mass[i]);
}

TEST_CASE("the guards name what went wrong and where") {
  System system = test::make_system(test::grid_mesh({3, 3}));
  CHECK_NOTHROW(check_state(system));
  const Vec2 good = system.particles.position[0];
  system.particles.position[0].x = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(check_state(system), Catch::Contains("not finite") && Catch::Contains("step 0"));
  system.particles.position[0] = good + Vec2{50.0, 50.0};
  CHECK_THROWS_WITH(check_state(system), Catch::Contains("turned over") && Catch::Contains("closing_rate_mm_per_s"));
  system.blocks.emplace_back();
  CHECK_THROWS_WITH(check_state(system), Catch::Contains("turned over") && Catch::Contains("shear_rate_mm_per_s"));
  system.particles.position[0] = good;
  test::change_points(system.contacts, 0, [&](PointState& s) { s.normal = -0.6 * system.contacts.edges[0].length; });
  CHECK_THROWS_WITH(check_state(system), Catch::Contains("overlap"));
}

TEST_CASE("kinetic energy above the work done stops a run, unless the literal law created it") {
  const System system = test::make_system(test::grid_mesh({2, 2}));
  EnergyBalance energy;
  energy.external_work = 1.0;
  energy.kinetic = 1.5;
  try {
    check_energy(system, energy);
    FAIL("no error");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::numerical);
  }
  energy.created_by_law = 1.0;
  CHECK_NOTHROW(check_energy(system, energy));
}

TEST_CASE("a velocity that is not finite is found, and its node or the fastest one named") {
  System system = test::make_system(test::grid_mesh({2, 2}));
  update_velocities(system, kLoops);
  CHECK_NOTHROW(check_all(system, kLoops));
  const std::size_t last = system.particles.node_count() - 1;
  const Vec2 place = system.particles.reference(last);
  char near[64];
  std::snprintf(near, sizeof near, "near (%.4g, %.4g) mm", place.x, place.y);
  system.particles.velocity[last] = {1e3, 0};
  update_velocities(system, kLoops);
  CHECK_THROWS_WITH(check_all(system, kLoops), Catch::Contains("exceeds the work done") && Catch::Contains(near));
  system.particles.velocity[last].x = std::numeric_limits<double>::quiet_NaN();
  update_velocities(system, kLoops);
  CHECK_THROWS_WITH(check_all(system, kLoops), Catch::Contains("velocity is not finite") && Catch::Contains(near));
}

TEST_CASE("platens push back in proportion, beyond the skin, and friction is limited") {
  System system = test::make_system(test::grid_mesh({2, 2}));
  system.platens.present = true;
  system.platens.y = {0.01, 100.0};
  system.platens.friction = 0.5;
  system.platen_springs = {{0, 1}, {{200.0, 0.0}, {200.0, 0.02}}, {0.0, 0.0}};
  system.particles.position[0] = {0.0, 0.0};
  system.particles.position[1] = {2.0, 0.0};
  system.particles.velocity[0] = {1e9, 0.0};
  update_velocities(system, kLoops);
  CHECK(system.sums.reaction[0] == Approx(2.0));  // 200 N/mm times 0.01 mm; node 1 is within its skin
  CHECK(system.platen_shear[0] == Approx(-1.0));  // mu N against the motion
  CHECK(system.sums.reaction[1] == 0.0);
}
