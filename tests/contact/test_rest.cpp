#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/units.hpp"
#include "tests/support/bodies.hpp"

using namespace asperity;

namespace {

constexpr double kGravity = 1e6;  // mm/s2: heavy, so that milliseconds are enough
constexpr int kBlocks = 5;

/// Contact damping takes the bouncing; the bodies' own vibration and their rocking on each other need local damping,
/// which adds no force to a body at rest.
test::BodyMaterial damped_material(double friction) {
  test::BodyMaterial material;
  material.youngs_modulus = 20000.0;
  material.surface = {friction, 500.0, 500.0};
  material.damping_ratio = 0.3;
  return material;
}

double weight_of(const System& system, int body) { return test::motion_of(system, body).mass * kGravity; }

/// Body 0 is the held base; five irregular blocks with different meshes, offset by up to 6 % of their width, lie 0.02
/// mm over each other.
System drop_stack() {
  constexpr double width = 14.0;
  const double offset[kBlocks] = {0.0, 0.7, -0.5, 0.3, -0.8};
  const int columns[kBlocks] = {6, 5, 7, 4, 5};
  test::Bodies bodies;
  bodies.add_block({-16.0, -4.0}, {8, 1, 4.0, 0.0});
  double y = 0.02;
  for (int i = 0; i < kBlocks; ++i) {
    const double edge = width / columns[i];
    bodies.add_block({offset[i] - 0.5 * width, y}, {columns[i], 3, edge, 0.25});
    y += 3 * edge + 0.02;
  }
  System system = test::make_bodies(bodies, damped_material(0.5), 0.5);
  test::hold(system, 0);
  system.local_damping = 0.5;
  system.body_acceleration = {0.0, -kGravity};
  return system;
}

std::vector<Vec2> centres(const System& system) {
  std::vector<Vec2> result;
  for (int i = 1; i <= kBlocks; ++i) result.push_back(test::motion_of(system, i).centre);
  return result;
}

/// A notch of two held bodies (0 left, 1 right) whose flanks rise at two angles (rad) from a narrow gap, and a triangle
/// (2) of the same angles over it, turned by `tilt`.
struct Notch {
  double left, right, tilt;
};

System drop_fragment(const Notch& notch) {
  constexpr double flank = 20.0, thickness = 4.0, side = 10.0, gap = 0.5, height = 0.3;
  test::Bodies bodies;
  const test::Grid wall{10, 2, 2.0, 0.2};
  bodies.add_block(Vec2{-gap, 0.0} + test::turned({-flank, -thickness}, -notch.left), wall, -notch.left);
  bodies.add_block(Vec2{gap, 0.0} + test::turned({0.0, -thickness}, notch.right), wall, notch.right);
  const Vec2 a{0.0, 0.0}, b = test::turned({side, 0.0}, notch.right), c = test::turned({-side, 0.0}, -notch.left);
  const Vec2 centre = (1.0 / 3.0) * (a + b + c);
  std::vector<Vec2> vertices{a, 0.5 * (a + b), b, 0.5 * (b + c), c, 0.5 * (c + a)};
  for (Vec2& v : vertices) v = Vec2{0.0, height} + centre + test::turned(v - centre, notch.tilt);
  bodies.add(vertices, {{0, 1, 5}, {1, 2, 3}, {3, 4, 5}, {1, 3, 5}});
  System system = test::make_bodies(bodies, damped_material(0.0), 0.5);
  test::hold(system, 0);
  test::hold(system, 1);
  system.local_damping = 0.4;
  system.body_acceleration = {0.0, -kGravity};
  return system;
}

/// Force on a flank against what statics wants: its part along the flank's inward normal and the part along the flank.
void check_flank(const char* which, Vec2 force, double angle, double exact) {
  const Vec2 inward = test::turned({0.0, -1.0}, angle);
  WARN("  " << which << " flank: force over exact " << dot(force, inward) / exact << ", along the flank "
            << cross(force, inward) / exact);
  CHECK(dot(force, inward) == Approx(exact).epsilon(0.005));
  CHECK(std::abs(cross(force, inward)) < 0.005 * exact);
}

}  // namespace

TEST_CASE("A dropped stack of five irregular blocks comes to rest, carries its weight and stays") {
  System system = drop_stack();
  double weight = 0.0, potential = 0.0;
  for (int i = 1; i <= kBlocks; ++i) {
    weight += weight_of(system, i);
    potential += weight_of(system, i) * test::motion_of(system, i).centre.y;
  }
  test::EnergyWatch watch;
  test::run_until(system, 4e-3, watch);
  const double kinetic = system.sums.kinetic / potential, carried = -test::force_on(system, 0).y / weight;
  const std::vector<Vec2> before = centres(system);
  test::run_until(system, 7e-3, watch);
  const std::vector<Vec2> after = centres(system);
  double creep = 0.0;
  for (int i = 0; i < kBlocks; ++i) creep = std::max(creep, norm(after[i] - before[i]));
  const double carried_later = -test::force_on(system, 0).y / weight;
  WARN("stack: kinetic energy over potential " << kinetic << ", later " << system.sums.kinetic / potential
                                               << ", base carries " << carried << ", later " << carried_later
                                               << ", creep " << creep << " mm, energy " << watch.relative());
  CHECK(kinetic < 1e-9);
  CHECK(system.sums.kinetic / potential < 1e-12);
  CHECK(carried == Approx(1.0).margin(0.001));
  CHECK(carried_later == Approx(1.0).margin(0.001));
  CHECK(creep < 1e-5);
  CHECK(watch.relative() < 1e-3);
}

TEST_CASE("A fragment in a notch without friction presses with W sin(other angle) / sin(sum) on each flank") {
  const auto [left_deg, right_deg] = GENERATE(table<double, double>({{35, 50}, {60, 25}, {45, 45}}));
  const double tilt = GENERATE(0.05, -0.05);
  const Notch notch{left_deg * units::kRadPerDeg, right_deg * units::kRadPerDeg, tilt};
  System system = drop_fragment(notch);
  const double weight = weight_of(system, 2), sine = std::sin(notch.left + notch.right);
  test::EnergyWatch watch;
  test::run_until(system, 6e-3, watch);
  WARN("notch " << left_deg << " and " << right_deg << " degrees, tilt " << tilt << ": kinetic energy "
                << system.sums.kinetic / weight << " weight mm, energy " << watch.relative());
  CHECK(system.sums.kinetic < 1e-9 * weight);
  check_flank("left", test::force_on(system, 0), -notch.left, weight * std::sin(notch.right) / sine);
  check_flank("right", test::force_on(system, 1), notch.right, weight * std::sin(notch.left) / sine);
  CHECK(watch.relative() < 1e-3);
}
