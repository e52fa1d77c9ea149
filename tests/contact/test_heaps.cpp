#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/heaps.hpp"

using namespace asperity;

namespace {

const ParallelLoops kLoops;

constexpr int kHeaps = 1000;
/// s: the fastest pieces cross a third of the box, those that start together part and meet others.
constexpr double kDuration = 3e-4;
/// Of the stable time step. The account's error goes with its square (frictionless heaps: factor 4.0 for each halving);
/// 0.2 leaves the worst of the thousand at two thirds of what is allowed.
constexpr double kSafety = 0.2;

/// What one heap showed.
struct HeapRun {
  double energy_error = 0;               ///< Largest |error| of the account over the work done.
  double force_sum = 0, moment_sum = 0;  ///< Of all internal forces, over the sum of their magnitudes.
  double friction_fall = 0;              ///< Largest fall of the energy spent in friction, over the work done.
  bool finite = true, inside = true, apart = true;
  bool touched = false;
};

void watch_forces(const System& system, HeapRun& run) {
  Vec2 sum;
  double moment = 0, size = 0, moment_size = 0;
  for (std::size_t i = 0; i < system.particles.node_count(); ++i) {
    const Vec2 f = internal_force(system, i), x = system.particles.position[i];
    sum += f;
    moment += cross(x, f);
    size += norm(f);
    moment_size += norm(x) * norm(f);
  }
  run.force_sum = std::max(run.force_sum, norm(sum) / size);
  run.moment_sum = std::max(run.moment_sum, std::abs(moment) / moment_size);
}

bool all_inside(const test::Heap& heap) {
  // Thicker than any overlap, thinner than the walls.
  const double margin = 0.5;
  for (int body = 1; body <= heap.pieces; ++body) {
    for (int node : test::nodes_of(heap.system, body)) {
      const Vec2 x = heap.system.particles.position[node];
      if (!(std::min(x.x, x.y) > -margin && std::max(x.x, x.y) < heap.side + margin)) return false;
    }
  }
  return true;
}

/// No triangle's centroid lies in a triangle of another body.
bool all_apart(const System& system) {
  const Particles& p = system.particles;
  for (std::size_t a = 0; a < p.triangle_count(); ++a) {
    const auto x = p.corners(a);
    const Vec2 centroid = (1.0 / 3.0) * (x[0] + x[1] + x[2]);
    for (std::size_t b = 0; b < p.triangle_count(); ++b) {
      if (p.grain[a] == p.grain[b]) continue;
      const PresentTriangle t = present_triangle(p.shape(b), p.corners(b));
      if (t.depth(0, centroid) > 0 && t.depth(1, centroid) > 0 && t.depth(2, centroid) > 0) return false;
    }
  }
  return true;
}

HeapRun run_heap(test::Heap& heap) {
  System& system = heap.system;
  HeapRun run;
  double largest_error = 0, friction = 0, fall = 0;
  EnergyBalance energy;
  while (run.finite && system.time < kDuration) {
    compute_forces(system, kLoops);
    update_velocities(system, kLoops);
    if (system.step % 20 == 0) {
      energy = energy_balance(system, kLoops);
      run.finite = std::isfinite(energy.error());
      largest_error = std::max(largest_error, std::abs(energy.error()));
      fall = std::max(fall, friction - energy.friction);
      friction = energy.friction;
      run.touched = run.touched || !system.general.touches.empty();
    }
    if (system.step % 200 == 0) watch_forces(system, run);
    update_positions(system, kLoops);
  }
  const double gravity_work = std::abs(energy.external_work - system.initial_kinetic);
  run.energy_error = largest_error / (system.initial_kinetic + gravity_work);
  run.friction_fall = fall / (system.initial_kinetic + gravity_work);
  run.inside = all_inside(heap);
  run.apart = all_apart(system);
  return run;
}

}  // namespace

TEST_CASE("A thousand random heaps keep finite, apart and in their box, and their energy account closes to 0.1 %") {
  HeapRun worst;
  int touched = 0, corner_starts = 0, pieces = 0;
  double deepest = 0;
  for (int seed = 0; seed < kHeaps; ++seed) {
    test::Heap heap = test::random_heap(seed, kSafety);
    const HeapRun run = run_heap(heap);
    CAPTURE(seed, heap.pieces, run.energy_error, run.force_sum, run.moment_sum, run.friction_fall);
    REQUIRE(run.finite);
    CHECK(run.energy_error < 1e-3);
    CHECK(run.inside);
    CHECK(run.apart);
    CHECK(run.force_sum < 1e-11);   // rounding of some hundred forces of either sign
    CHECK(run.moment_sum < 1e-11);  // the same
    CHECK(run.friction_fall < 1e-4);
    worst.energy_error = std::max(worst.energy_error, run.energy_error);
    worst.force_sum = std::max(worst.force_sum, run.force_sum);
    worst.moment_sum = std::max(worst.moment_sum, run.moment_sum);
    worst.friction_fall = std::max(worst.friction_fall, run.friction_fall);
    deepest = std::max(deepest, heap.system.general.largest_depth);
    touched += run.touched;
    corner_starts += heap.corner_starts;
    pieces += heap.pieces;
  }
  // The heaps are heaps: pieces meet, and many start corner on corner.
  CHECK(touched > 0.9 * kHeaps);
  CHECK(corner_starts > kHeaps);
  WARN("worst energy error " << worst.energy_error << ", forces " << worst.force_sum << ", moments " << worst.moment_sum
                             << ", fall of friction " << worst.friction_fall << "; deepest " << deepest << " mm, "
                             << pieces << " pieces, " << corner_starts << " corner starts, " << touched << " touched");
}
