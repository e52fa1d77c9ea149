#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/units.hpp"
#include "tests/support/bodies.hpp"

using namespace asperity;

namespace {

constexpr double kTop = 20.0;                                 // mm, height of the blocks
constexpr double kPressure = 1.0, kForce = kPressure * kTop;  // MPa, N per mm, on each block's outer face
constexpr double kDrive = 20.0;                               // mm/s, of the platen that drives the wedge
constexpr double kQuiet = 0.3;                                // local damping while nothing is measured

/// A symmetric wedge between two blocks. These stand on the bottom platen, the top one drives the wedge, both without
/// friction; a pressure pushes the blocks together. Statics, with N and mu N on each flank:
///   block: H = N (cos b - mu sin b);  wedge: P = 2 N (sin b + mu cos b), so P = 2 H tan(b + phi);
/// on the way out friction acts the other way: P = 2 H tan(b - phi), and nothing has to hold the wedge if b < phi.
struct WedgeModel {
  System system;
  double beta, mu;
  int wedge = 0, right = 0, left = 0;
  test::EnergyWatch watch;
};

test::Bodies wedge_and_blocks(WedgeModel& model) {
  const auto face = [&](double y) { return 3.0 + y * std::tan(model.beta); };
  const double low = 2.0, high = kTop + 4.0, outer = face(kTop) + 12.0;
  test::Bodies bodies;
  model.wedge = bodies.add_quadrilateral(
      {Vec2{-face(low), low}, {face(low), low}, {face(high), high}, {-face(high), high}}, {4, 8, 3.0, 0.2});
  model.right =
      bodies.add_quadrilateral({Vec2{face(0), 0}, {outer, 0}, {outer, kTop}, {face(kTop), kTop}}, {5, 7, 3.0, 0.2});
  model.left =
      bodies.add_quadrilateral({Vec2{-outer, 0}, {-face(0), 0}, {-face(kTop), kTop}, {-outer, kTop}}, {5, 7, 3.0, 0.2});
  return bodies;
}

/// Pressure on all edges of the outermost vertical faces, which come with the body on their left.
void load_outer_faces(System& system) {
  const Particles& p = system.particles;
  double outer = 0.0;
  for (const Vec2& x : p.vertices) outer = std::max(outer, x.x);
  const auto on_face = [&](int node) { return std::abs(p.reference(node).x) > outer - 1e-6; };
  for (const auto& nodes : p.triangles) {
    for (int k = 0; k < 3; ++k) {
      if (on_face(nodes[k]) && on_face(nodes[(k + 1) % 3])) {
        system.flank.edges.push_back({{nodes[k], nodes[(k + 1) % 3]}, 1.0});
      }
    }
  }
}

WedgeModel make_wedge(double beta, double mu) {
  WedgeModel model;
  model.beta = beta;
  model.mu = mu;
  test::BodyMaterial material;
  material.youngs_modulus = 20000.0;
  material.surface = {mu, 300.0, 300.0};
  material.damping_ratio = 0.5;
  model.system = test::make_bodies(wedge_and_blocks(model), material, 0.5);
  System& system = model.system;
  system.platens.present = true;
  system.platens.y = {0.0, kTop + 4.0};
  system.platen_springs.other = {3000.0, 0.0};
  system.time_step = 0.5 * critical_time_step(system, ParallelLoops());
  system.local_damping = kQuiet;
  load_outer_faces(system);
  return model;
}

/// Reactions of the platens, mean over a stretch of steps, N per mm of thickness.
struct Reactions {
  double bottom = 0, top = 0;
};

Reactions run(WedgeModel& model, double span) {
  Reactions sum;
  int steps = 0;
  test::run_until(model.system, model.system.time + span, model.watch, [&] {
    sum.bottom += model.system.sums.reaction[0];
    sum.top += model.system.sums.reaction[1];
    ++steps;
  });
  return {sum.bottom / steps, sum.top / steps};
}

void press(WedgeModel& model) {
  for (int i = 1; i <= 20; ++i) {
    model.system.flank.pressure = kPressure * i / 20;
    run(model, 2e-5);
  }
}

/// Brings the driving platen to a velocity (mm/s, upwards) and moves it on until the wedge slides steadily; the mean
/// reactions of the last stretch. Local damping quiets the change of direction; it is off while the forces are
/// measured, because on sliding nodes it is a drag. Left alone for milliseconds the faces begin to rattle (see the
/// incline).
Reactions drive(WedgeModel& model, double velocity) {
  const double before = model.system.platens.velocity[1];
  for (int i = 1; i <= 20; ++i) {
    model.system.platens.velocity[1] = before + (velocity - before) * i / 20;
    run(model, 1e-5);
  }
  run(model, 9e-4);
  model.system.local_damping = 0.0;
  const Reactions mean = run(model, 3e-4);
  model.system.local_damping = kQuiet;
  return mean;
}

/// Height of the wedge over the blocks (mm) and its velocity (mm/s).
struct Rise {
  double height, velocity;
};

Rise rise(const WedgeModel& model) {
  const auto wedge = test::motion_of(model.system, model.wedge);
  const auto left = test::motion_of(model.system, model.left), right = test::motion_of(model.system, model.right);
  return {wedge.centre.y - 0.5 * (left.centre.y + right.centre.y),
          wedge.velocity.y - 0.5 * (left.velocity.y + right.velocity.y)};
}

/// Acceleration (mm/s2) at which the blocks expel the wedge. Wedge, upwards: m a = 2 N (sin b - mu cos b); each block,
/// inwards: M a tan b = H - N (cos b + mu sin b).
double exact_expulsion(const WedgeModel& model) {
  const double wedge = test::motion_of(model.system, model.wedge).mass;
  const double block = test::motion_of(model.system, model.right).mass;
  const double lift = std::sin(model.beta) - model.mu * std::cos(model.beta);
  const double normal = kForce / (std::cos(model.beta) + model.mu * std::sin(model.beta) +
                                  2.0 * block / wedge * std::tan(model.beta) * lift);
  return 2.0 * normal * lift / wedge;
}

void check_force(const char* way, const Reactions& found, double exact) {
  WARN("  " << way << ": P over exact " << found.top / exact << ", base over exact " << found.bottom / exact);
  CHECK(found.top == Approx(exact).epsilon(0.005));
  CHECK(found.bottom == Approx(exact).epsilon(0.005));
}

/// The platen has left and the blocks must hold the wedge. They hang on each other now, free to drift together by the
/// slight tilt of the pressed faces, so motion is that against the blocks.
void check_held(WedgeModel& model, const Reactions& released) {
  CHECK(released.top == 0.0);
  const Rise before = rise(model);
  run(model, 3e-4);
  const Rise after = rise(model);
  WARN("  released: held, moves by " << after.height - before.height << " mm at " << after.velocity << " mm/s");
  CHECK(std::abs(after.height - before.height) < 1e-6);
  CHECK(std::abs(after.velocity) < 0.01);
}

/// The platen disappears upwards and the blocks must throw the wedge out. Nothing damps the vibration that this leaves
/// in the bodies, which is why the tolerance is not that of the forces.
void check_expelled(WedgeModel& model) {
  model.system.local_damping = 0.0;
  model.system.platens.velocity[1] = 1000.0;
  run(model, 1e-5);
  model.system.platens.velocity[1] = 2e4;
  run(model, 4e-5);
  const double start = model.system.time;
  const double before = test::motion_of(model.system, model.wedge).velocity.y;
  run(model, 4e-4);
  const double acceleration =
      (test::motion_of(model.system, model.wedge).velocity.y - before) / (model.system.time - start);
  const double exact = exact_expulsion(model);
  WARN("  released: expelled, acceleration over exact " << acceleration / exact);
  CHECK(acceleration == Approx(exact).epsilon(0.02));
}

}  // namespace

TEST_CASE("A wedge between two blocks: 2 H tan(beta + phi) in, 2 H tan(beta - phi) out, held if beta < phi") {
  const double mu = GENERATE(0.0, 0.4);
  const double beta = GENERATE(15.0, 30.0) * units::kRadPerDeg;
  const double phi = std::atan(mu);
  WedgeModel model = make_wedge(beta, mu);
  WARN("wedge, mu " << mu << ", beta " << beta / units::kRadPerDeg);
  press(model);
  check_force("in", drive(model, -kDrive), 2.0 * kForce * std::tan(beta + phi));
  const Reactions back = drive(model, kDrive);
  if (beta < phi) {
    check_held(model, back);
  } else {
    check_force("out", back, 2.0 * kForce * std::tan(beta - phi));
    check_expelled(model);
  }
  WARN("  energy " << model.watch.relative());
  CHECK(model.watch.relative() < 1e-3);
}
