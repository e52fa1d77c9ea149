#include <catch2/catch.hpp>
#include <cstring>

#include "core/base/instruction_set.hpp"
#include "core/integrator/platen_contact.hpp"
#include "tests/support/models.hpp"

using namespace asperity;

namespace {

const ParallelLoops kLoops;

/// 18 by 14 mm of particles, or of grains that share nodes, that two platens press, the upper one turned.
System pressed(Kernel kernel, bool grains, double slope, double inertia) {
  Mesh mesh = test::grid_mesh({9, 7});
  for (std::size_t t = 0; grains && t < mesh.grain.size(); ++t) mesh.grain[t] = static_cast<int>(t / 2);
  const RunConfig config = test::plaster();
  System system;
  system.particles = make_particles(mesh, config.particles, config.experiment.plane);
  system.contacts = make_contacts(mesh, system.particles, test::unbreakable_law(), LawReading::consistent);
  system.kernel = kernel;
  prepare(system);
  system.local_damping = 0.4;
  system.platens.present = true;
  system.platens.y = {0.0, 14.05};
  system.platens.velocity = system.platens.last_velocity = {100.0, -100.0};
  system.platens.upper = {slope, 9.0, 9.0, inertia, 0.0, 0.0};
  system.platen_springs.other = {500.0, 0.0};
  system.time_step = 0.5 * critical_time_step(system, kLoops);
  return system;
}

/// The left corner just touches, and the platens close quickly.
System touching(Kernel kernel, bool grains, double inertia) {
  System system = pressed(kernel, grains, 0.02, inertia);
  system.platens.y[1] = 14.18;
  system.platens.velocity = system.platens.last_velocity = {300.0, -300.0};
  return system;
}

bool same_bytes(const System& a, const System& b) {
  const auto same = [](const std::vector<Vec2>& x, const std::vector<Vec2>& y) {
    return std::memcmp(x.data(), y.data(), x.size() * sizeof(Vec2)) == 0;
  };
  return same(a.particles.position, b.particles.position) && same(a.particles.velocity, b.particles.velocity) &&
         a.external_work == b.external_work && a.platens.upper.slope == b.platens.upper.slope;
}

}  // namespace

TEST_CASE("a turned face stands higher by slope times place, and presses along y") {
  System system = pressed(Kernel::reference, false, 0.01, 0.0);
  int met = 0;
  for (std::size_t i = 0; i < system.particles.node_count(); ++i) {
    const Vec2 rest = system.particles.reference(i);
    system.particles.position[i] = rest + Vec2{0.5, 0.02};  // moved aside: the place at rest counts
    const PlatenContact contact = platen_contact(system, i);
    if (rest.y < 1.0) continue;
    CHECK(contact.touch.depth == Approx(rest.y + 0.02 - 14.05 - 0.01 * (rest.x - 9.0)).margin(1e-12));
    if (contact.overlap <= 0.0) continue;
    ++met;
    CHECK(rest.x < 6.0 + 1e-9);  // 14.02 > 14.05 + 0.01 (x - 9) left of x = 6
    CHECK(contact.touch.normal == Vec2{0.0, -1.0});
  }
  CHECK(met > 3);
  CHECK(lowest_of_upper_face(system.platens) == Approx(14.05 - 0.09).epsilon(1e-12));
}

TEST_CASE("the moment about the hinge is that of the nodes' forces, and turns the face") {
  System system = pressed(Kernel::reference, false, 0.01, 2e-5);
  for (auto& x : system.particles.position) x.y += 0.02;
  compute_forces(system, kLoops);
  double moment = 0.0, load = 0.0;
  for (std::size_t i = 0; i < system.particles.node_count(); ++i) {
    const PlatenContact contact = platen_contact(system, i);
    if (contact.side == 0 || contact.overlap <= 0.0) continue;
    load += 500.0 * contact.overlap;
    moment += 500.0 * contact.overlap * (system.particles.reference(i).x - 9.0);
  }
  update_velocities(system, kLoops);
  CHECK(system.sums.reaction[1] == Approx(load).epsilon(1e-12));
  CHECK(system.sums.turning == Approx(moment).epsilon(1e-12));
  CHECK(moment < 0.0);  // pushed up on the left
  const double undamped = system.time_step / 2e-5 * moment;
  CHECK(system.platens.upper.rate == Approx(0.6 * undamped).epsilon(1e-9));  // local damping 0.4
}

TEST_CASE("under a turned face the fast kernel is the reference, with any instruction set") {
  for (const bool grains : {false, true}) {
    for (const double inertia : {0.0, 2e-5}) {
      System fast = touching(Kernel::fast, grains, inertia);
      System reference = touching(Kernel::reference, grains, inertia);
      test::advance(fast, kLoops, 200);
      test::advance(reference, kLoops, 200);
      CHECK(fast.sums.reaction[1] > 0.0);
      double worst = 0.0;
      for (std::size_t i = 0; i < fast.particles.node_count(); ++i) {
        worst = std::max(worst, norm(fast.particles.velocity[i] - reference.particles.velocity[i]));
      }
      INFO("largest difference of velocities " << worst << " mm/s");
      CHECK(worst < 1e-8 * 300.0);  // 200 steps of rounding
      for (const InstructionSet& set : instruction_sets()) {
        const ForcedInstructionSet forced(set);
        System again = touching(Kernel::fast, grains, inertia);
        test::advance(again, kLoops, 200);
        INFO(set.name);
        CHECK(same_bytes(again, fast));
      }
    }
  }
}

TEST_CASE("the energy account of an elastic specimen under a face that turns is closed") {
  for (const double inertia : {0.0, 2e-5}) {
    System system = touching(Kernel::fast, false, inertia);
    test::advance(system, kLoops, 3000);
    compute_forces(system, kLoops);
    update_velocities(system, kLoops);
    const EnergyBalance energy = energy_balance(system, kLoops);
    INFO("slope " << system.platens.upper.slope << ", work " << energy.external_work << ", error " << energy.error());
    CHECK(energy.external_work > 0.0);
    CHECK(std::abs(energy.error()) < 1e-4 * energy.external_work);
    if (inertia > 0.0) CHECK(std::abs(system.platens.upper.slope) < 0.015);  // it lies down on the specimen's end
  }
}
