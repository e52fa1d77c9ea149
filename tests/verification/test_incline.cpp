#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/units.hpp"
#include "tests/support/models.hpp"

using namespace asperity;

namespace {

constexpr double kEdge = 2.0, kGravity = 1e7;  // mm, mm/s2: heavy, so that a millisecond is enough
constexpr double kDamping = 0.7;

/// A base row of cells with a lower, shorter block on it: eight columns of cells on twelve.
Mesh block_on_base() {
  Mesh mesh = test::grid_mesh({12, 2, kEdge, 0.0});
  Mesh kept = mesh;
  kept.triangles.clear();
  for (const auto& t : mesh.triangles) {
    Vec2 centre;
    for (int v : t) centre += (1.0 / 3.0) * mesh.vertices[static_cast<std::size_t>(v)];
    if (centre.y < kEdge || (centre.x > 2 * kEdge && centre.x < 10 * kEdge)) kept.triangles.push_back(t);
  }
  kept.grain.clear();
  for (int t = 0; t < static_cast<int>(kept.triangles.size()); ++t) kept.grain.push_back(t);
  return kept;
}

bool in_base(const Particles& p, std::size_t triangle) {
  double y = 0.0;
  for (int node : p.triangles[triangle]) y += p.reference(static_cast<std::size_t>(node)).y / 3.0;
  return y < kEdge;
}

void break_interface(System& system) {
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const ContactEdge& e = system.contacts.edges[c];
    if (in_base(system.particles, static_cast<std::size_t>(e.left_triangle())) ==
        in_base(system.particles, static_cast<std::size_t>(e.right_triangle())))
      continue;
    test::break_in_shear(system.contacts, c);
  }
}

System make_incline(LawReading reading) {
  RunConfig config = test::plaster();
  config.contacts.law.reading = reading;
  System system = test::make_system(block_on_base(), config);
  break_interface(system);
  system.held.assign(system.particles.node_count(), 0);
  for (std::size_t t = 0; t < system.particles.triangle_count(); ++t) {
    if (!in_base(system.particles, t)) continue;
    for (int node : system.particles.triangles[t]) system.held[static_cast<std::size_t>(node)] = 1;
  }
  return system;
}

struct Motion {
  double mean_x = 0, velocity = 0;
};

Motion block_motion(const System& system) {
  Motion sum;
  double mass = 0.0;
  for (std::size_t i = 0; i < system.particles.node_count(); ++i) {
    if (system.held[i]) continue;
    const double m = system.particles.mass[i];
    mass += m;
    sum.mean_x += m * (system.particles.position[i].x - system.particles.reference(i).x);
    sum.velocity += m * system.particles.velocity[i].x;
  }
  return {sum.mean_x / mass, sum.velocity / mass};
}

/// Acceleration (mm/s2) of the block over the last half millisecond of three, on an incline of the given angle; gravity
/// comes on over the first. Local damping takes its share of every node's resultant, so a sliding block has 1 -
/// kDamping of the free one's acceleration; without damping the sliding faces rattle and friction, rebuilt at k_s after
/// each lift, lags.
double acceleration_at(double angle, double strength, LawReading reading) {
  const ParallelLoops loops;
  System system = make_incline(reading);
  const Vec2 gravity = strength * Vec2{std::sin(angle), -std::cos(angle)};
  const double span = 5e-4;
  system.local_damping = kDamping;
  while (system.time < 2 * span) {
    system.body_acceleration = std::min(1.0, system.time / span) * gravity;
    test::advance(system, loops);
  }
  const Motion start = block_motion(system);
  while (system.time < 3 * span) test::advance(system, loops);
  return (block_motion(system).velocity - start.velocity) / span;
}

/// Median over five gravities that differ by 1e-9: under the literal law, which creates energy, the block trembles, and
/// now and then (4 of 60) a jump falls into the half millisecond.
double median_acceleration(double angle, LawReading reading) {
  std::array<double, 5> found;
  for (int i = 0; i < 5; ++i) found[i] = acceleration_at(angle, kGravity * (1.0 + 1e-9 * i), reading);
  std::nth_element(found.begin(), found.begin() + 2, found.end());
  return found[2];
}

}  // namespace

TEST_CASE("A block on an incline sticks half a degree below the friction angle and slides half a degree above") {
  const LawReading reading = GENERATE(LawReading::consistent, LawReading::literal);
  const double phi = RunConfig{}.contacts.friction_angle_deg;
  const double low = (phi - 0.5) * units::kRadPerDeg, high = (phi + 0.5) * units::kRadPerDeg;
  const double exact =
      (1.0 - kDamping) * kGravity * (std::sin(high) - std::cos(high) * std::tan(phi * units::kRadPerDeg));
  const double below = median_acceleration(low, reading), above = median_acceleration(high, reading);
  WARN("incline: acceleration over the exact sliding one: " << below / exact << " below, " << above / exact
                                                            << " above phi");
  CHECK(std::abs(below) < 0.01 * exact);  // it rests: what is left is undamped trembling
  // 1 - kDamping is for steady forces; damping |F| of trembling nodes brakes more. 30 % are 0.15 degrees of friction
  // angle.
  CHECK(above == Approx(exact).epsilon(0.3));
}
