#include <catch2/catch.hpp>

#include "core/base/random.hpp"
#include "core/integrator/platen_contact.hpp"
#include "tests/support/models.hpp"

using namespace asperity;

namespace {

const ParallelLoops kLoops;

/// Apexes at y = 1 and 61, arcs of 45 mm about x = 3, 60 mm wide in blocks that are level beyond.
Platens jaws() {
  Platens p;
  p.present = true;
  p.y = {1.0, 61.0};
  p.jaw = {45.0, 3.0, 30.0, 45.0 - std::sqrt(45.0 * 45.0 - 30.0 * 30.0)};
  return p;
}

}  // namespace

TEST_CASE("a flat platen's face is level: depth along y, normal to the specimen") {
  Platens p;
  p.y = {1.0, 61.0};
  const PlatenTouch bottom = platen_touch(p, 0, {17.0, 0.75}), top = platen_touch(p, 1, {-4.0, 61.5});
  CHECK(bottom.depth == 0.25);
  CHECK(bottom.normal == Vec2{0.0, 1.0});
  CHECK(top.depth == 0.5);
  CHECK(top.normal == Vec2{0.0, -1.0});
  CHECK(along_face(bottom, 0) == Vec2{1.0, 0.0});
  CHECK(along_face(top, 1) == Vec2{1.0, 0.0});
  CHECK(platen_touch(p, 0, {0.0, 30.0}).depth == -29.0);
}

TEST_CASE("a jaw's face is its arc, and level beyond it") {
  const Platens p = jaws();
  CHECK(platen_touch(p, 0, {3.0, 0.5}).depth == Approx(0.5));  // under the apex
  CHECK(platen_touch(p, 1, {3.0, 61.5}).depth == Approx(0.5));
  const double rise = 45.0 - std::sqrt(45.0 * 45.0 - 20.0 * 20.0);
  const PlatenTouch on_arc = platen_touch(p, 0, {23.0, 1.0 + rise});
  CHECK(on_arc.depth == Approx(0.0).margin(1e-12));
  CHECK(on_arc.normal.x == Approx(-20.0 / 45.0));  // to the arc's centre
  CHECK(on_arc.normal.y == Approx(std::sqrt(1.0 - 16.0 / 81.0)));
  const PlatenTouch mirrored = platen_touch(p, 1, {23.0, 61.0 - rise - 0.1});
  CHECK(mirrored.depth < 0.0);
  CHECK(mirrored.normal.y < 0.0);
  const PlatenTouch level = platen_touch(p, 0, {50.0, 1.0 + p.jaw.depth - 0.25});
  CHECK(level.depth == Approx(0.25));
  CHECK(level.normal == Vec2{0.0, 1.0});
  CHECK(level.bend == 0.0);
  CHECK(platen_touch(p, 0, {3.0, 60.0}).depth < 0.0);    // in front of the other jaw
  CHECK(platen_touch(p, 0, {400.0, 31.0}).depth < 0.0);  // far aside, above the blocks
}

TEST_CASE("the normal is minus the depth's gradient, and the depth goes on over the arc's end") {
  const Platens p = jaws();
  RandomStream random(5, "test jaws");
  int arcs = 0, levels = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec2 x{random.uniform(-40.0, 46.0), random.uniform(-2.0, 64.0)};
    const int side = static_cast<int>(random.uniform() < 0.5);
    const PlatenTouch touch = platen_touch(p, side, x);
    constexpr double h = 1e-6;
    const Vec2 gradient{
        (platen_touch(p, side, x + Vec2{h, 0}).depth - platen_touch(p, side, x - Vec2{h, 0}).depth) / (2 * h),
        (platen_touch(p, side, x + Vec2{0, h}).depth - platen_touch(p, side, x - Vec2{0, h}).depth) / (2 * h)};
    CHECK(norm(gradient + touch.normal) < 1e-7);  // rounding over h; none of the points lies on the seam
    (touch.bend > 0.0 ? arcs : levels) += touch.depth > 0.0;
    const double near = std::abs(platen_touch(p, side, x + Vec2{h, h}).depth - touch.depth);
    CHECK(near < 2 * h);
  }
  CHECK(arcs > 50);
  CHECK(levels > 10);
}

TEST_CASE("on an arc friction acts along it, against the motion relative to the jaw, and both forces react") {
  System system = test::make_system(test::grid_mesh({2, 2}));
  system.platens = jaws();
  system.platens.friction = 0.5;
  system.platen_springs = {{0}, {{200.0, 0.0}}, {0.0, 0.0}};
  const double rise = 45.0 - std::sqrt(45.0 * 45.0 - 20.0 * 20.0);
  const PlatenTouch arc = platen_touch(system.platens, 0, {23.0, 1.0 + rise});
  system.particles.position[0] = Vec2{23.0, 1.0 + rise} - 0.01 * arc.normal;
  const Vec2 along = along_face(arc, 0);
  system.particles.velocity[0] = 1e9 * along;
  update_velocities(system, kLoops);
  CHECK(system.platen_shear[0] == Approx(-1.0));  // mu times 200 N/mm times 0.01 mm
  CHECK(system.sums.reaction[0] == Approx(2.0 * arc.normal.y - 1.0 * along.y));
  CHECK(along.y > 0.0);  // it rises to the right there
  // A node that moves with the jaw does not slide, though the arc is inclined.
  system.platen_shear[0] = 0.0;
  system.platens.last_velocity = {300.0, 0.0};
  system.particles.velocity[0] = {0.0, 300.0};
  update_velocities(system, kLoops);
  CHECK(system.platen_shear[0] == Approx(0.0).margin(1e-12));
}
