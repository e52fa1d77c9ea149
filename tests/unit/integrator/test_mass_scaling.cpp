#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/error.hpp"
#include "core/integrator/time_step.hpp"
#include "tests/support/models.hpp"

using namespace asperity;

namespace {

const ParallelLoops kLoops;

System unbreakable() { return test::make_system(test::grid_mesh({6, 6}), test::plaster(), test::unbreakable_law()); }

double total(const std::vector<double>& mass) {
  double sum = 0.0;
  for (double m : mass) sum += m;
  return sum;
}

/// Largest energy, over the first, of an undamped free vibration of a scaled system at a multiple of its critical step.
double energy_growth(double multiple) {
  System system = unbreakable();
  const double asked = 1.6 * critical_time_step(system, kLoops);
  scale_masses_uniformly(system, asked, kLoops);
  system.time_step = multiple * asked;
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

TEST_CASE("uniform mass scaling reaches the critical step asked for and makes no node lighter") {
  for (double factor : {1.05, 1.5, 3.0}) {
    System system = unbreakable();
    const std::vector<double> before = system.particles.mass;
    const double asked = factor * critical_time_step(system, kLoops);
    const double added = scale_masses_uniformly(system, asked, kLoops);
    CHECK(critical_time_step(system, kLoops) == Approx(asked).epsilon(2e-3));
    for (std::size_t i = 0; i < before.size(); ++i) REQUIRE(system.particles.mass[i] >= before[i]);
    CHECK(added == Approx(total(system.particles.mass) / total(before) - 1.0).epsilon(1e-12));
    CHECK(added > 0.0);
    CHECK(added < factor * factor - 1.0);  // heavier everywhere by the square would do it too, and cost more
  }
}

TEST_CASE("a uniform step that the specimen already has adds nothing, and a shorter one is an error") {
  System system = unbreakable();
  const std::vector<double> before = system.particles.mass;
  const double own = critical_time_step(system, kLoops);
  CHECK(scale_masses_uniformly(system, own, kLoops) < 0.01);
  system.particles.mass = before;
  CHECK_THROWS_AS(scale_masses_uniformly(system, 0.5 * own, kLoops), Error);
}

TEST_CASE("the power iteration still divides stable from unstable motion once all nodes need the same step") {
  CHECK(energy_growth(0.97) < 50.0);  // near the limit the leapfrog's energy swings, but stays bounded
  CHECK(energy_growth(1.02) > 1e6);
}

TEST_CASE("internal forces keep the momentum of a scaled specimen") {
  System system = unbreakable();
  scale_masses_uniformly(system, 2.0 * critical_time_step(system, kLoops), kLoops);
  test::scatter_velocities(system, 1.0);
  const auto momentum = [&] {
    Vec2 sum;
    for (std::size_t i = 0; i < system.particles.node_count(); ++i) {
      sum += system.particles.mass[i] * system.particles.velocity[i];
    }
    return sum;
  };
  const Vec2 before = momentum();
  test::advance(system, kLoops, 500);
  CHECK(norm(momentum() - before) < 1e-10 * norm(before));
}
