#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/sliders.hpp"

using namespace asperity;

namespace {

const ParallelLoops kLoops;
constexpr double kEdge = 2.0;  // mm
constexpr double kMu = 0.5;

/// Relative deviations: mean, standard deviation and largest.
struct Noise {
  int count = 0;
  double sum = 0, squares = 0, largest = 0;
  void see(double deviation) {
    ++count;
    sum += deviation;
    squares += deviation * deviation;
    largest = std::max(largest, std::abs(deviation));
  }
  double mean() const { return sum / count; }
  double deviation() const { return std::sqrt(squares / count - mean() * mean()); }
};

/// A block of five irregular edges on a held surface of irregular edges, pressed down by its weight.
struct SlidingBlock {
  System system;
  test::Drive drive;
  double normal_force;  // N per mm
};

SlidingBlock sliding_block(double pressure) {
  test::BodyMaterial material;
  const double depth = pressure / material.surface.k_n;
  const std::vector<double> widths = test::irregular_lengths(5, 1.7, 2);
  double length = 0;
  for (double w : widths) length += w;
  test::Bodies bodies;
  test::add_strip(bodies, {-20.0, -2.0}, test::irregular_lengths(75, kEdge, 1), 1, 2.0);
  test::add_strip(bodies, {0.0, -depth}, widths, 2, 3.4);
  SlidingBlock block{test::make_bodies(bodies, material, 0.5), {}, pressure * length};
  test::hold(block.system, 0);
  block.system.body_acceleration = {0.0, -block.normal_force / test::motion_of(block.system, 1).mass};
  // The undamped block flutters, as a brake squeals; in steady sliding this damping takes no force.
  block.system.local_damping = 0.4;
  block.drive = test::drive_above(block.system, 1, 3.0);
  return block;
}

/// Velocity of a journey out and back, mm/s: smooth ramps, so that the block hardly rings when its friction turns
/// round.
struct Journey {
  double speed, ramp, turn;
  /// From -1 to 1 with flat ends and a flat middle.
  static double smooth(double x) {
    const double a = std::min(1.0, std::abs(x));
    return std::copysign(a * a * a * (10.0 + a * (6.0 * a - 15.0)), x);
  }
  double velocity(double t) const {
    return t < 0.0 ? 0.0 : speed * std::min(smooth(t / ramp), smooth((turn - t) / ramp));
  }
};

/// Relative deviations from mu N of the friction on the surface, in three parts of a journey.
struct SlidingRun {
  Noise out, reversal, back;
  double drive = 0;  ///< Mean force of the drive over mu N on the way back at full speed.
  double path = 0, farthest = 0;
};

/// Friction counts as reversed once the block has come back this far, mm: many times the elastic slip and the block's
/// own shear under mu N.
constexpr double kReversed = 0.1;

SlidingRun slide(SlidingBlock& block, double distance) {
  System& system = block.system;
  const double limit = kMu * block.normal_force;
  const double settled = 2e-4;
  Journey journey{5000.0, 2e-3, 0.0};
  journey.turn = distance / journey.speed + journey.ramp;
  SlidingRun run;
  Noise drive;
  double x = 0;
  while (run.path < 2.0 * distance - kEdge) {
    const double t = system.time - settled;
    const double v = journey.velocity(t);
    test::advance_driven(system, block.drive, v, kLoops);
    run.path += std::abs(v) * system.time_step;
    x += v * system.time_step;
    run.farthest = std::max(run.farthest, x);
    const double deviation = std::copysign(1.0, v) * test::force_on(system, 0).x / limit - 1.0;
    const bool near_turn = std::abs(t - journey.turn) < journey.ramp;
    if (v > 0.0 && x > 0.5 * kEdge) (near_turn ? run.reversal : run.out).see(deviation);
    if (v < 0.0 && run.farthest - x > kReversed) (near_turn ? run.reversal : run.back).see(deviation);
    if (v < 0.0 && t > journey.turn + journey.ramp) drive.see(-block.drive.resistance / limit);
  }
  run.drive = drive.mean();
  return run;
}

/// A triangle that stands on its tip, `depth` mm below a surface of irregular edges, with both held.
struct Tip {
  System system;
  std::vector<double> ends;  ///< x of the surface's edge ends, mm.
};

Tip standing_tip(double x, double depth, double tilt, double mu) {
  const std::vector<double> lengths = test::irregular_lengths(8, kEdge, 5);
  Tip tip;
  tip.ends.push_back(0.0);
  for (double length : lengths) tip.ends.push_back(tip.ends.back() + length);
  test::Bodies bodies;
  test::add_strip(bodies, {0.0, -2.0}, lengths, 1, 2.0);
  std::vector<Vec2> corners{{0.0, 0.0}, {1.5, 2.6}, {-1.5, 2.6}};
  for (Vec2& v : corners) v = Vec2{x < 0.0 ? tip.ends[3] + x : x, -depth} + test::turned(v, tilt);
  bodies.add(corners, {{0, 1, 2}});
  test::BodyMaterial material;
  material.surface.tan_phi = mu;
  tip.system = test::make_bodies(bodies, material, 0.3);
  test::hold(tip.system, 0);
  test::hold(tip.system, 1);
  return tip;
}

/// Moves the tip by `distance` in so many steps and calls visit() after each.
template <class Visit>
void move_tip(System& system, double distance, int steps, const Visit& visit) {
  test::set_velocity(system, 1, {distance / (steps * system.time_step), 0.0});
  for (int i = 0; i < steps; ++i) {
    compute_forces(system, kLoops);
    update_velocities(system, kLoops);
    visit();
    update_positions(system, kLoops);
  }
  compute_forces(system, kLoops);
}

}  // namespace

TEST_CASE("A pressed block slides 50 irregular edges and back: friction work, force noise, no snagging") {
  for (double pressure : {1.0, 5.0}) {
    SlidingBlock block = sliding_block(pressure);
    const SlidingRun run = slide(block, 50 * kEdge);
    const double work = block.system.general.friction_energy / (kMu * block.normal_force * run.path);
    CAPTURE(pressure, run.path, run.farthest, work, run.drive);
    for (const Noise* noise : {&run.out, &run.reversal, &run.back}) {
      CAPTURE(noise->count, noise->mean(), noise->deviation(), noise->largest);
      CHECK(noise->deviation() < 0.02);
      CHECK(noise->largest < 0.02);
    }
    CHECK(run.farthest == Approx(50 * kEdge).epsilon(1e-3));
    CHECK(work == Approx(1.0).margin(0.005));
    CHECK(run.drive == Approx(1.0).margin(0.005));
    WARN(pressure << " MPa: friction work " << work << ", mean drive " << run.drive << " of mu N; noise out "
                  << run.out.deviation() << " (" << run.out.largest << "), at the reversal " << run.reversal.deviation()
                  << " (" << run.reversal.largest << "), back " << run.back.deviation() << " (" << run.back.largest
                  << ")");
  }
}

TEST_CASE("A corner dragged over edge ends loses no friction at a change of partner") {
  for (double tilt : {0.0, 0.25}) {
    const double depth = 0.02;
    Tip tip = standing_tip(1.0, depth, tilt, kMu);
    const int steps = 40000;
    const double distance = 5.0 * kEdge;
    double x = 0, before = 0, full = 0, drop = 0, share = 0;
    int most_touches = 0;
    move_tip(tip.system, distance, steps, [&] {
      x += distance / steps;
      const test::FrictionForce friction = test::friction_on(tip.system, 1, kMu);
      const double force = -friction.force.x;
      full = std::max(full, force);
      if (x > depth) {  // elastic slip at the start: mu times the depth
        drop = std::max(drop, std::min(before, friction.limit) - force);
        share += force / friction.limit / steps / (1.0 - depth / distance);
      }
      before = force;
      most_touches = std::max(most_touches, static_cast<int>(tip.system.general.touches.size()));
    });
    CAPTURE(tilt, drop, full, share);
    CHECK(drop < 0.01 * full);                  // less than its limit only where it was less before
    CHECK(share == Approx(1.0).margin(0.005));  // as in the block's friction work
    CHECK(most_touches >= 3);                   // there were edge ends
    WARN("tilt " << tilt << ": largest drop " << drop / full << " of the full force, mean share of the limit "
                 << share);
  }
}

TEST_CASE("A sticking corner goes over an edge end and back: its tangential force is continuous and returns") {
  for (double tilt : {0.0, 0.25}) {
    const double depth = 0.02, start = -0.025, reach = 0.05;
    // So rough that not even the parts next to the edge's end slip, where the depth below the nearest edge is small.
    Tip tip = standing_tip(start, depth, tilt, 1e7);
    const int steps = 2000;
    std::vector<double> out, back;
    const auto see = [&](std::vector<double>& forces) {
      return [&] { forces.push_back(-test::friction_on(tip.system, 1, 1.0).force.x); };
    };
    move_tip(tip.system, reach, steps, see(out));
    move_tip(tip.system, -reach, steps, see(back));
    const double end = -test::friction_on(tip.system, 1, 1.0).force.x;
    const double largest = out.back();
    double jump = 0, apart = 0;
    for (int i = 1; i < steps; ++i) {
      jump = std::max({jump, std::abs(out[i] - out[i - 1]), std::abs(back[i] - back[i - 1])});
      apart = std::max(apart, std::abs(out[i] - back[steps - i]));
    }
    CAPTURE(tilt, largest, jump / largest, apart / largest, end / largest);
    CHECK(tip.system.general.friction_energy < 1e-3 * 0.5 * largest * reach);
    CHECK(largest > 1.0);  // N per mm
    CHECK(jump < 0.01 * largest);
    CHECK(apart < 0.01 * largest);
    CHECK(std::abs(end) < 0.01 * largest);
    WARN("tilt " << tilt << ": largest force " << largest << " N/mm, jump " << jump / largest << ", out and back apart "
                 << apart / largest << ", left at the end " << end / largest);
  }
}
