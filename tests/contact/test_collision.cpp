#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/bodies.hpp"

using namespace asperity;

namespace {

Vec2 momentum(const System& system) {
  Vec2 sum;
  for (std::size_t i = 0; i < system.particles.node_count(); ++i) {
    sum += system.particles.mass[i] * system.particles.velocity[i];
  }
  return sum;
}

double angular_momentum(const System& system) {
  const Particles& p = system.particles;
  double sum = 0.0;
  for (std::size_t i = 0; i < p.node_count(); ++i) {
    // Half a step back, where the velocities belong.
    sum += p.mass[i] * cross(p.position[i] - 0.5 * system.time_step * p.velocity[i], p.velocity[i]);
  }
  return sum;
}

struct BarCollision {
  double duration, restitution;  ///< Duration over 2 L / c.
  double momentum_error;         ///< Over the momentum of one bar.
  double energy_error;
};

/// Two equal bars of so many cells in a row meet at `speed` each. Exact: a compression wave runs through each bar,
/// comes back as tension after 2 L / c and parts them, all at rest inside and with velocities exchanged. What is left
/// over:
/// * Penalty: the face follows u' = v - 2 k u / (rho c), so the pressure comes and goes with the time E / (2 k c), a
/// share
///   E / (4 k L) of the duration: 1 / 8 cell in L with k = 2 E / edge. A much stiffer face rattles: it parts and meets
///   again.
/// * Mesh: the wave disperses over some edge (L / edge)^(1/3), which delays the end of the contact by the share
///   (edge / L)^(2/3) and leaves about that share of the energy as vibration: 1 % takes some 150 cells.
BarCollision collide_bars(int cells) {
  constexpr double edge = 2.0, speed = 50.0;
  test::BodyMaterial material;
  material.poissons_ratio = 0.0;
  material.surface.k_n = material.surface.k_s = 2.0 * material.youngs_modulus / edge;
  test::Bodies bodies;
  const double length = cells * edge;
  bodies.add_block({0, 0}, {cells, 2, edge, 0.2});
  bodies.add_block({length + 1e-3, 0}, {cells, 2, edge, 0.2});
  System system = test::make_bodies(bodies, material, 0.3);
  test::set_velocity(system, 0, {speed, 0});
  test::set_velocity(system, 1, {-speed, 0});
  book_initial_kinetic_energy(system);
  const double wave = std::sqrt(material.youngs_modulus / (material.density * 1e-12));
  double first = -1.0, last = -1.0;
  test::EnergyWatch watch;
  test::run_until(system, 1.3 * 2.0 * length / wave, watch, [&] {
    if (system.general.touches.empty()) return;
    if (first < 0.0) first = system.time;
    last = system.time;
  });
  const auto a = test::motion_of(system, 0), b = test::motion_of(system, 1);
  return {(last - first) * wave / (2.0 * length), (b.velocity.x - a.velocity.x) / (2.0 * speed),
          norm(momentum(system)) / (a.mass * speed), watch.relative()};
}

/// What meets head on: squares of four triangles round their centre, or single triangles with a right angle at the tip.
/// Both are symmetric about the axis of approach.
enum class TipShape { square, triangle };

/// A body whose tip is at the origin and points along +x, turned by `angle` and then moved to `tip`.
int add_tip(test::Bodies& bodies, TipShape shape, Vec2 tip, double angle) {
  constexpr double size = 5.0;
  if (shape == TipShape::square) return bodies.add_wheel(tip - test::turned({size, 0.0}, angle), size, 4, angle);
  return bodies.add({tip, tip + test::turned({-size, size}, angle), tip + test::turned({-size, -size}, angle)},
                    {{0, 1, 2}});
}

/// How a collision is set up: the picture is turned by `frame` rad, the right body is `offset` mm off the axis.
struct TipCase {
  TipShape shape;
  double offset = 0, frame = 0, friction = 0;
};

/// Velocities afterwards, in the picture's own frame, over the speed of approach; errors over a body's momentum (times
/// 1 mm), largest speed of any node over the speed of approach.
struct TipCollision {
  Vec2 left, right;
  double spin_left, spin_right;  ///< Angular momentum over mass and speed, mm.
  double momentum_error, angular_momentum_error, energy_error, fastest;
  bool met_and_parted;
};

/// Slow against the bodies' own vibrations, so that next to nothing is left in these.
TipCollision collide_tips(const TipCase& c) {
  constexpr double speed = 1000.0;
  test::BodyMaterial material;
  material.youngs_modulus = 20000.0;
  material.surface = {c.friction, 200.0, 200.0};
  test::Bodies bodies;
  add_tip(bodies, c.shape, test::turned({-0.01, 0.0}, c.frame), c.frame);
  add_tip(bodies, c.shape, test::turned({0.01, c.offset}, c.frame), c.frame + std::numbers::pi);
  System system = test::make_bodies(bodies, material, 0.2);
  test::set_velocity(system, 0, test::turned({speed, 0}, c.frame));
  test::set_velocity(system, 1, test::turned({-speed, 0}, c.frame));
  book_initial_kinetic_energy(system);
  const double before = angular_momentum(system);
  test::EnergyWatch watch;
  double fastest = 0.0;
  bool met = false;
  test::run_until(system, 8e-4, watch, [&] {
    fastest = std::max(fastest, std::sqrt(system.sums.fastest));
    met = met || !system.general.touches.empty();
  });
  const auto a = test::motion_of(system, 0), b = test::motion_of(system, 1);
  const double unit = a.mass * speed;
  return {(1.0 / speed) * test::turned(a.velocity, -c.frame),
          (1.0 / speed) * test::turned(b.velocity, -c.frame),
          a.angular_momentum / unit,
          b.angular_momentum / unit,
          norm(momentum(system)) / unit,
          std::abs(angular_momentum(system) - before) / unit,
          watch.relative(),
          fastest / speed,
          met && system.general.touches.empty()};
}

void check_conservation(const TipCollision& c) {
  CHECK(c.met_and_parted);
  CHECK(c.momentum_error < 1e-12);
  CHECK(c.angular_momentum_error < 1e-12);
  CHECK(c.energy_error < 1e-3);
  CHECK(c.fastest < 2.0);
}

}  // namespace

TEST_CASE("Two elastic bars collide: duration 2 L / c, restitution 1, momentum to rounding") {
  const BarCollision coarse = collide_bars(120), found = collide_bars(240);
  WARN("bars: duration " << found.duration << " (" << coarse.duration << " with half the cells), restitution "
                         << found.restitution << " (" << coarse.restitution << "), momentum " << found.momentum_error
                         << ", energy " << found.energy_error);
  CHECK(found.duration == Approx(1.0).margin(0.01));
  CHECK(found.restitution == Approx(1.0).margin(0.01));
  CHECK(std::abs(found.duration - 1.0) < std::abs(coarse.duration - 1.0));
  CHECK(std::abs(found.restitution - 1.0) < std::abs(coarse.restitution - 1.0));
  for (const BarCollision& c : {coarse, found}) {
    CHECK(c.momentum_error < 1e-12);
    CHECK(c.energy_error < 1e-3);
  }
}

TEST_CASE("Corner on corner, exactly aligned: restitution 1 and no deflection in any frame") {
  const TipShape shape = GENERATE(TipShape::square, TipShape::triangle);
  for (double frame : {0.0, 0.3, std::numbers::pi / 4.0, 1.2, 2.9}) {
    const TipCollision c = collide_tips({shape, 0.0, frame});
    CAPTURE(frame);
    check_conservation(c);
    const double restitution = 0.5 * (c.right.x - c.left.x);
    if (frame == 0.3)
      WARN("tips aligned: restitution " << restitution << ", deflection " << c.left.y << ", energy " << c.energy_error
                                        << ", momentum " << c.momentum_error);
    CHECK(restitution == Approx(1.0).margin(0.01));
    CHECK(std::max(std::abs(c.left.y), std::abs(c.right.y)) < 1e-10);
    CHECK(std::max(std::abs(c.spin_left), std::abs(c.spin_right)) < 1e-10);
  }
}

TEST_CASE("Corner on corner, off the axis: mirrored offsets give mirrored motion, tiny ones tiny deflection") {
  const TipShape shape = GENERATE(TipShape::square, TipShape::triangle);
  const double friction = GENERATE(0.0, 0.5);
  for (double offset : {1e-12, 1e-9, 1e-6, 1e-3, 0.03, 0.3}) {
    const TipCollision up = collide_tips({shape, offset, 0.3, friction});
    const TipCollision down = collide_tips({shape, -offset, 0.3, friction});
    const TipCollision level = collide_tips({shape, offset, 0.0, friction});
    CAPTURE(offset, friction, up.left.x, up.left.y, down.left.y, level.left.y);
    for (const TipCollision& c : {up, down, level}) check_conservation(c);
    CHECK(std::abs(up.left.x - down.left.x) < 1e-8);
    CHECK(std::abs(up.left.y + down.left.y) < 1e-8);
    CHECK(std::abs(up.spin_left + down.spin_left) < 1e-8);
    CHECK(norm(up.left - level.left) < 1e-8);
    // Tips slip off each other: found 0.8 to 350 a mm, the same for every small offset. A normal that is chosen, and
    // not given by a potential, deflects by order 1 however small the offset.
    CHECK(std::abs(up.left.y) < 500.0 * offset + 1e-9);
  }
}
