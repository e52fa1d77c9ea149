#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <numbers>

#include "core/measurement/crack_network.hpp"
#include "tests/support/models.hpp"

using namespace asperity;

namespace {

double largest_force(const System& system) {
  double largest = 0.0;
  for (std::size_t i = 0; i < system.particles.node_count(); ++i) {
    largest = std::max(largest, norm(internal_force(system, i)));
  }
  return largest;
}

void place(System& system, double angle, Vec2 shift) {
  for (std::size_t i = 0; i < system.particles.node_count(); ++i) {
    system.particles.position[i] = test::turned(system.particles.reference(i), angle) + shift;
  }
}

struct Momentum {
  Vec2 linear;
  double angular = 0, linear_size = 0, angular_size = 0;
};

/// Linear and angular momentum about the origin; sizes are the sums of absolute shares, what rounding is relative to.
Momentum momentum(const Particles& p) {
  Momentum sum;
  for (std::size_t i = 0; i < p.node_count(); ++i) {
    sum.linear += p.mass[i] * p.velocity[i];
    sum.angular += p.mass[i] * cross(p.position[i], p.velocity[i]);
    sum.linear_size += p.mass[i] * norm(p.velocity[i]);
    sum.angular_size += p.mass[i] * norm(p.position[i]) * norm(p.velocity[i]);
  }
  return sum;
}

bool same_bytes(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec2)) == 0;
}

constexpr double kSpeed = 1e4;  // mm/s; t_c / (density * wave speed) = 6e3 breaks the plaster

/// With little more fracture energy than the hardening needs, so that contacts fail in tension too before they shear.
RunConfig brittle_plaster(LawForm form = LawForm::damage_slip) {
  RunConfig config = test::plaster();
  config.contacts.fracture_energy_n_per_mm = 0.05;
  config.contacts.law.form = form;
  return config;
}

bool broken_in_both_modes(const System& system) {
  const CrackCounts cracks = count_cracks(system.contacts, ParallelLoops());
  return cracks.tension > 3 && cracks.shear > 3;
}

struct Outcome {
  System system;
  EnergyBalance energy;
};

Outcome torn_by(int threads, LawForm form) {
  const ParallelLoops loops(threads);
  Outcome outcome{test::make_system(test::grid_mesh({36, 36}), brittle_plaster(form)),
                  {}};  // 2,592 triangles: three blocks, 4 of contacts
  test::scatter_velocities(outcome.system, kSpeed);
  outcome.system.local_damping = 0.3;
  test::advance(outcome.system, loops, 150);
  outcome.energy = test::advance_with_energy(outcome.system, loops);
  return outcome;
}

}  // namespace

TEST_CASE("Rigid motion of a bonded assembly gives no force") {
  System system = test::make_system(test::grid_mesh({6, 6}));
  const ParallelLoops loops;
  for (int step = 0; step <= 36; ++step) {
    const Vec2 shift = (step % 2) * Vec2{300.0, -700.0};
    place(system, 2.0 * std::numbers::pi * step / 36, shift);
    compute_forces(system, loops);
    // A coordinate is only known to 1e-16 of its size, and stiffness times edge turns that into a force: 1e-12 of it
    // leaves room for some thousand roundings.
    const double size = norm(shift) + 12.0 * std::numbers::sqrt2;
    CHECK(largest_force(system) < 1e-12 * system.contacts.law.k_t * 2.0 * size);
  }
}

TEST_CASE("A free assembly keeps its momenta through breakage") {
  System system = test::make_system(test::grid_mesh({6, 6}), brittle_plaster());
  const ParallelLoops loops;
  test::scatter_velocities(system, kSpeed);
  const Momentum start = momentum(system.particles);
  test::advance(system, loops, 300);
  const Momentum end = momentum(system.particles);
  const CrackCounts cracks = count_cracks(system.contacts, loops);
  const double linear = norm(end.linear - start.linear) / start.linear_size;
  const double angular = std::abs(end.angular - start.angular) / start.angular_size;
  WARN("momentum lost: linear " << linear << ", angular " << angular << "; cracks " << cracks.tension << " + "
                                << cracks.shear);
  CHECK(broken_in_both_modes(system));  // otherwise nothing was tried
  CHECK(linear < 1e-13);                // 300 steps of 216 nodes, 1e-16 each, adding up at random
  CHECK(angular < 1e-13);
}

TEST_CASE("Damage and contact energies never fall in a violent run, under any law") {
  RunConfig config = brittle_plaster(GENERATE(LawForm::damage_slip, LawForm::cohesive_frictional));
  config.contacts.law.reading = GENERATE(LawReading::consistent, LawReading::literal);
  System system = test::make_system(test::grid_mesh({6, 6}), config);
  const ParallelLoops loops;
  test::scatter_velocities(system, kSpeed);
  int falls = 0;
  for (int step = 0; step < 300; ++step) {
    const BondedContacts before = system.contacts;
    test::advance(system, loops);
    for (std::size_t c = 0; c < before.size(); ++c) {
      for (int q = 0; q < 2; ++q) {
        const PointState was = before.points(c)[q], is = system.contacts.points(c)[q];
        falls += is.damage < was.damage || is.fracture_energy < was.fracture_energy ||
                 is.friction_energy < was.friction_energy;
      }
    }
  }
  CHECK(falls == 0);
  CHECK(broken_in_both_modes(system));
}

TEST_CASE("Any number of threads gives the same bytes") {
  const LawForm form = GENERATE(LawForm::damage_slip, LawForm::cohesive_frictional);
  const Outcome one = torn_by(1, form);
  REQUIRE(broken_in_both_modes(one.system));
  for (const int threads : {2, 4, 8}) {
    const Outcome many = torn_by(threads, form);
    CHECK(same_bytes(one.system.particles.position, many.system.particles.position));
    CHECK(same_bytes(one.system.particles.velocity, many.system.particles.velocity));
    CHECK(one.system.contacts.broken_index == many.system.contacts.broken_index);
    CHECK(std::memcmp(&one.energy, &many.energy, sizeof(EnergyBalance)) == 0);
  }
}
