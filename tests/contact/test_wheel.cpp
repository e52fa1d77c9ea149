#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/bodies.hpp"

using namespace asperity;

namespace {

constexpr double kRadius = 20.0;   // mm, to the corners
constexpr double kSpeed = 5000.0;  // mm/s, of rolling at first
constexpr int kCorners = 60;
constexpr int kTurns = 10;
const double kHeight = kRadius * std::cos(std::numbers::pi / kCorners);  // of the centre over an edge that lies flat
const double kPerimeter = 2.0 * kCorners * kRadius * std::sin(std::numbers::pi / kCorners);

/// Clockwise turns of a body, followed by the direction of one of its spokes.
class TurnCounter {
 public:
  TurnCounter(const System& system, int body) : nodes_(test::nodes_of(system, body)), last_(spoke(system)) {}
  void see(const System& system) {
    const Vec2 now = spoke(system);
    turns_ -= std::atan2(cross(last_, now), dot(last_, now)) / (2.0 * std::numbers::pi);
    last_ = now;
  }
  double turns() const { return turns_; }

 private:
  Vec2 spoke(const System& system) const {
    return system.particles.position[nodes_[1]] - system.particles.position[nodes_[0]];
  }
  std::vector<int> nodes_;
  Vec2 last_;
  double turns_ = 0.0;
};

struct Wheel {
  System system;
  int body;
};

/// A wheel of triangles flat on one edge on a long held base; gravity holds it down at this speed.
Wheel make_wheel(double damping_ratio) {
  test::BodyMaterial material;
  material.youngs_modulus = 500.0;
  material.surface = {0.8, 40.0, 40.0};
  material.damping_ratio = damping_ratio;
  test::Bodies bodies;
  const int base = bodies.add_block({-30.0, -20.0}, {static_cast<int>((kTurns + 1) * kPerimeter / 20.0), 1, 20.0, 0.0});
  const int wheel = bodies.add_wheel({0.0, kHeight}, kRadius, kCorners, -std::numbers::pi * (0.5 + 1.0 / kCorners));
  Wheel result{test::make_bodies(bodies, material, 0.6), wheel};
  test::hold(result.system, base);
  result.system.body_acceleration = {0.0, -1.2 * kSpeed * kSpeed / kRadius};
  return result;
}

/// Velocity `speed` of the centre and `spin` (rad/s, clockwise) about it.
void start(Wheel& wheel, double speed, double spin) {
  Particles& p = wheel.system.particles;
  for (int node : test::nodes_of(wheel.system, wheel.body)) {
    const Vec2 arm = p.position[node] - Vec2{0.0, kHeight};
    p.velocity[node] = Vec2{speed, 0.0} + spin * Vec2{arm.y, -arm.x};
  }
  book_initial_kinetic_energy(wheel.system);
}

/// How a wheel rolled: mechanical energy is kinetic + elastic + of the contacts + of height; all over the initial one.
struct Roll {
  double largest_rise = 0;  ///< Of mechanical energy over the least of it before.
  double left = 1;          ///< Mechanical energy at the end.
  double energy_error = 0;  ///< Largest error of the account.
  double turns = 0, distance = 0;
};

/// Rolls until so many more turns are done.
Roll roll(Wheel& wheel, double turns) {
  const ParallelLoops loops;
  System& system = wheel.system;
  const double initial = system.initial_kinetic;
  TurnCounter counter(system, wheel.body);
  const double from = test::motion_of(system, wheel.body).centre.x;
  const double latest = system.time + 5.0 * turns * kPerimeter / kSpeed;
  Roll result;
  double least = 1e300;
  while (counter.turns() < turns && system.time < latest) {
    const EnergyBalance e = test::advance_with_energy(system, loops);
    counter.see(system);
    result.left = 1.0 + (e.kinetic + e.elastic + e.recoverable - e.external_work) / initial;
    least = std::min(least, result.left);
    result.largest_rise = std::max(result.largest_rise, result.left - least);
    result.energy_error = std::max(result.energy_error, std::abs(e.error()) / initial);
  }
  result.turns = counter.turns();
  result.distance = test::motion_of(system, wheel.body).centre.x - from;
  return result;
}

void check(const Roll& found) {
  const double no_slip = found.distance / (found.turns * kPerimeter);
  WARN("wheel: " << found.turns << " turns, distance over turns x perimeter " << no_slip << ", energy left "
                 << found.left << ", largest rise " << found.largest_rise << ", energy error " << found.energy_error);
  CHECK(found.turns >= kTurns);
  CHECK(found.largest_rise < 1e-6);
  CHECK(found.left <= 1.0);
  CHECK(found.energy_error < 1e-3);
  // It rolls on a radius that is less by the depth of the contact, 0.03 to 0.06 mm of 20.
  CHECK(no_slip == Approx(1.0).margin(0.005));
}

}  // namespace

TEST_CASE("A wheel of triangles rolls ten turns and never gains energy") {
  for (double damping_ratio : {0.0, 0.2}) {
    Wheel wheel = make_wheel(damping_ratio);
    start(wheel, kSpeed, kSpeed / kHeight);
    check(roll(wheel, kTurns));
  }
}

TEST_CASE("A wheel that starts without spin is spun up by friction to v0 / (1 + I / m R2) and rolls") {
  Wheel wheel = make_wheel(0.2);
  start(wheel, 1.5 * kSpeed, 0.0);
  double inertia = 0.0;
  const auto before = test::motion_of(wheel.system, wheel.body);
  for (int node : test::nodes_of(wheel.system, wheel.body)) {
    const Vec2 arm = wheel.system.particles.position[node] - before.centre;
    inertia += wheel.system.particles.mass[node] * dot(arm, arm);
  }
  const double exact = before.velocity.x / (1.0 + inertia / (before.mass * kHeight * kHeight));
  const Roll spin_up = roll(wheel, 0.25);
  const auto after = test::motion_of(wheel.system, wheel.body);
  const double spin = -after.angular_momentum / inertia;
  WARN("spin-up: speed over exact " << after.velocity.x / exact << ", spin over v / R "
                                    << spin * kHeight / after.velocity.x << ", energy left " << spin_up.left);
  CHECK(after.velocity.x == Approx(exact).epsilon(0.01));
  const Roll rolling = roll(wheel, 1.0);
  const double no_slip = rolling.distance / (rolling.turns * kPerimeter);
  WARN("then " << rolling.turns << " turns: distance over turns x perimeter " << no_slip);
  CHECK(no_slip == Approx(1.0).margin(0.005));
  CHECK(std::max(spin_up.largest_rise, rolling.largest_rise) < 1e-6);
  CHECK(std::max(spin_up.energy_error, rolling.energy_error) < 1e-3);
}
