#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/bodies.hpp"

using namespace asperity;

namespace {

constexpr double kEdge = 2.0;
const ParallelLoops kLoops;

/// Largest |error| of the energy account over a run of so many steps, over the largest external work.
struct EnergyWatch {
  double largest_error = 0, largest_work = 0;
  void see(const EnergyBalance& e) {
    largest_error = std::max(largest_error, std::abs(e.error()));
    largest_work = std::max(largest_work, std::abs(e.external_work));
  }
  double relative() const { return largest_error / largest_work; }
};

}  // namespace

TEST_CASE("Two elastic bars collide: duration, restitution 1 and momentum") {
  test::Bodies bodies;
  const int cells = 60;
  bodies.add_block({0, 0}, {cells, 2, kEdge, 0.2});
  bodies.add_block({cells * kEdge + 0.01, 0}, {cells, 2, kEdge, 0.2});
  test::BodyMaterial material;
  material.poissons_ratio = 0.0;
  material.surface.k_n = material.surface.k_s = 100.0 * material.youngs_modulus / kEdge;
  System system = test::make_bodies(bodies, material, 0.5);
  const double speed = 50.0;
  test::set_velocity(system, 0, {speed, 0});
  test::set_velocity(system, 1, {-speed, 0});
  book_initial_kinetic_energy(system);
  const double length = cells * kEdge;
  const double wave = std::sqrt(material.youngs_modulus / (material.density * 1e-12));
  double first = -1, last = -1;
  EnergyWatch watch;
  while (system.time < 4.0 * length / wave) {
    watch.see(test::advance_with_energy(system, kLoops));
    if (!system.general.touches.empty()) {
      if (first < 0) first = system.time;
      last = system.time;
    }
  }
  const auto a = test::motion_of(system, 0), b = test::motion_of(system, 1);
  const double duration = (last - first) / (2.0 * length / wave);
  const double restitution = (b.velocity.x - a.velocity.x) / (2.0 * speed);
  CAPTURE(duration, restitution, watch.relative(), a.velocity.x, b.velocity.x);
  CHECK(duration == Approx(1.0).margin(0.01));
  CHECK(restitution == Approx(1.0).margin(0.01));
  CHECK(std::abs(a.velocity.x + b.velocity.x) < 1e-10 * speed);
  CHECK(watch.relative() < 1e-3);
  WARN("duration " << duration << " restitution " << restitution << " energy " << watch.relative());
}

TEST_CASE("A block on an incline sticks below phi and slides with the right acceleration above") {
  const double phi = std::atan(0.5);
  for (double excess : {-0.01, 0.02, 0.1}) {
    test::Bodies bodies;
    bodies.add_block({-100.0, -4.0}, {120, 2, kEdge, 0.0});
    bodies.add_block({-8.0, 0.0}, {8, 3, 1.7, 0.2});
    test::BodyMaterial material;
    System system = test::make_bodies(bodies, material, 0.5);
    test::hold(system, 0);
    const double gravity = 1e6;
    const double angle = phi + excess;
    system.body_acceleration = {gravity * std::sin(angle), -gravity * std::cos(angle)};
    EnergyWatch watch;
    system.local_damping = 0.0;
    system.general.law.damping_ratio = 0.5;
    const double settle = 2e-3, slide = 4e-3;
    Vec2 at_settled{};
    double travelled = 0, start = 0;
    while (system.time < settle + slide) {
      watch.see(test::advance_with_energy(system, kLoops));
      if (system.time < settle) {
        at_settled = test::motion_of(system, 1).velocity;
        start = test::motion_of(system, 1).centre.x;
      }
    }
    const auto motion = test::motion_of(system, 1);
    travelled = motion.centre.x - start;
    const double acceleration = (motion.velocity.x - at_settled.x) / slide;
    const double expected = excess < 0 ? 0.0 : gravity * (std::sin(angle) - 0.5 * std::cos(angle));
    WARN("excess " << excess << " acceleration " << acceleration / gravity << " expected " << expected / gravity
                   << " ratio " << acceleration / expected << " travelled " << travelled << " energy " << watch.relative());
    if (excess < 0) {
      CHECK(std::abs(acceleration) < 1e-3 * gravity);
    } else {
      CHECK(acceleration == Approx(expected).epsilon(0.005));
    }
    CHECK(watch.relative() < 1e-3);
  }
}
