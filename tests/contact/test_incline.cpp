#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/bodies.hpp"

using namespace asperity;

namespace {

constexpr double kGravity = 1e6;  // mm/s2: heavy, so that milliseconds are enough
constexpr double kFriction = 0.5;
constexpr double kSettled = 2e-3, kStart = 2.5e-3, kEnd = 4.5e-3;  // s

/// A stiff block on stiff contacts, damped on the approach only. A soft one (E = 1300 MPa) rattles without end:
/// sliding with constant friction between elastic bodies is unstable (Adams, J. Appl. Mech. 62, 1995), which is the
/// model's physics and not its error; the rattling block's mean friction is not mu.
test::BodyMaterial stiff_block() {
  test::BodyMaterial material;
  material.youngs_modulus = 20000.0;
  material.surface = {kFriction, 500.0, 500.0};
  material.damping_ratio = 0.2;
  return material;
}

struct Slide {
  double acceleration, energy_error;
};

/// Settles under gravity on the level, then tilts gravity; the block's acceleration along the base after transients.
Slide slide_at(double angle) {
  test::Bodies bodies;
  const int base = bodies.add_block({-16.0, -2.0}, {16, 1, 2.0, 0.0});
  const int block = bodies.add_block({-8.0, 0.0}, {8, 3, 1.7, 0.2});
  System system = test::make_bodies(bodies, stiff_block(), 0.5);
  test::hold(system, base);
  test::EnergyWatch watch;
  system.body_acceleration = {0.0, -kGravity};
  test::run_until(system, kSettled, watch);
  system.body_acceleration = kGravity * Vec2{std::sin(angle), -std::cos(angle)};
  test::run_until(system, kStart, watch);
  const double before = test::motion_of(system, block).velocity.x;
  test::run_until(system, kEnd, watch);
  return {(test::motion_of(system, block).velocity.x - before) / (kEnd - kStart), watch.relative()};
}

}  // namespace

TEST_CASE("A block on an incline sticks below the friction angle") {
  const double phi = std::atan(kFriction);
  for (double below : {0.1, 0.01}) {
    const Slide slide = slide_at(phi - below);
    WARN("incline " << below << " rad below phi: acceleration " << slide.acceleration / kGravity << " g, energy "
                    << slide.energy_error);
    CHECK(std::abs(slide.acceleration) <
          0.005 * kGravity * (std::sin(phi + below) - kFriction * std::cos(phi + below)));
    CHECK(slide.energy_error < 1e-3);
  }
}

TEST_CASE("A block on an incline slides with g (sin a - mu cos a) above the friction angle") {
  const double phi = std::atan(kFriction);
  for (double above : {0.02, 0.1, 0.3}) {
    const Slide slide = slide_at(phi + above);
    const double exact = kGravity * (std::sin(phi + above) - kFriction * std::cos(phi + above));
    WARN("incline " << above << " rad above phi: acceleration over exact " << slide.acceleration / exact << ", energy "
                    << slide.energy_error);
    CHECK(slide.acceleration == Approx(exact).epsilon(0.005));
    CHECK(slide.energy_error < 1e-3);
  }
}
