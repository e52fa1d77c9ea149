#include "core/experiment/step_benchmark.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/base/random.hpp"
#include "core/experiment/model.hpp"

namespace asperity {
namespace {

constexpr int kBatches = 7;
constexpr double kBatchSeconds = 0.08;
constexpr int kWarmUp = 10;

/// Strains of the specimen, and the shake of every triangle over the contacts' critical opening.
constexpr double kAxial = -0.006, kLateral = 0.0015, kShake = 0.25;

/// Operations of the fast kernels on doubles, counted in the code: every addition, product, comparison, minimum,
/// choice, division and square root is one, every branch taken but rare ones (sliding, softening). An edge: 44 for
/// frame and separations, 53 for its forces; each of its points: 15 for pressure and sliding, 76 for yield with two
/// exponentials of 25, 50 for damage with a third, 34 for hand-over, 12 for work and traction. A triangle: 76 from
/// positions to forces, 12 for its slots, 6 to look for platens; each of its nodes 49.
constexpr double kEdgeFlops = 44 + 53 + 2 * (15 + 76 + 50 + 34 + 12);
constexpr double kTriangleFlops = 76 + 12 + 6 + 3 * 49;

/// Bytes: an edge reads its description and memory (friction energy apart) and writes the memory but for friction and
/// damage, and its two slots twice over (the line is fetched first); a triangle reads positions in both passes, slots,
/// their indices, shape and masses, and reads and writes velocities and positions.
constexpr double kPointRows = 9, kWrittenRows = 7;
constexpr double kEdgeTraffic = sizeof(ContactEdge) + sizeof(int) + 2 * 8 * (kPointRows + kWrittenRows) + 2 * 64;
constexpr double kTriangleTraffic = 48 + 96 + 12 + 40 + 24 + 2 * 48 + 2 * 48;

class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

struct PassSeconds {
  double forces = 0, motion = 0;
  double sum() const { return forces + motion; }
};

PassSeconds time_steps(System& system, const ParallelLoops& loops, int steps) {
  PassSeconds sum;
  for (int i = 0; i < steps; ++i) {
    const Stopwatch forces;
    compute_forces(system, loops);
    sum.forces += forces.seconds();
    const Stopwatch motion;
    update_motion(system, loops);
    sum.motion += motion.seconds();
  }
  sum.forces /= steps;
  sum.motion /= steps;
  return sum;
}

int steps_in_batch(System& system, const ParallelLoops& loops) {
  const double one = time_steps(system, loops, kWarmUp).sum();
  return std::clamp(static_cast<int>(kBatchSeconds / one), 2, 1000);
}

template <class T>
std::size_t bytes(const std::vector<T>& values) {
  return values.size() * sizeof(T);
}

void strain_and_shake(System& system) {
  Particles& p = system.particles;
  RandomStream random(1, "step benchmark");
  const double reach = kShake * system.contacts.law.delta_ct;
  for (const auto& nodes : p.triangles) {
    const Vec2 shift{random.uniform(-reach, reach), random.uniform(-reach, reach)};
    for (int node : nodes) {
      const Vec2 x = p.reference(node);
      p.position[node] = x + Vec2{kLateral * x.x, kAxial * x.y} + shift;
    }
  }
  system.platens.y[1] *= 1.0 + kAxial;
}

}  // namespace

std::size_t memory_of(const System& s) {
  const Particles& p = s.particles;
  const BondedContacts& c = s.contacts;
  const GeneralContacts& g = s.general;
  return bytes(p.position) + bytes(p.velocity) + bytes(p.mass) + bytes(p.vertex) + bytes(p.vertices) +
         bytes(p.triangles) + bytes(p.shapes) + bytes(p.grain) + bytes(c.edges) + bytes(c.memory.packed) +
         bytes(c.memory.literal) + bytes(c.broken_index) + bytes(c.broken) + bytes(c.slot_of_edge) + bytes(g.members) +
         bytes(g.pairs) + bytes(g.chain_contacts) + bytes(g.handing_over) + bytes(g.touches) + bytes(g.frames) +
         bytes(g.forces) + bytes(g.set_free) + bytes(g.alive) + bytes(s.flank.edges) + bytes(s.flank.outline) +
         bytes(s.held) + bytes(s.platen_springs.nodes) + bytes(s.platen_springs.springs) + bytes(s.platen_shear) +
         bytes(s.forces) + bytes(s.loads.nodes) + bytes(s.loads.forces) + bytes(s.loads.places) +
         bytes(s.gather.begin) + bytes(s.gather.index);
}

System benchmark_system(int triangles) {
  RunConfig config;
  config.experiment.type = ExperimentType::uniaxial;
  const double scale = std::sqrt(triangles / 4158.0);  // what the shipped specimen of 54 x 130 mm has
  config.experiment.width_mm *= scale;
  config.experiment.height_mm *= scale;
  System system = build_model(config, ParallelLoops()).system;
  strain_and_shake(system);
  return system;
}

StepCost measure_step(const System& system, const ParallelLoops& loops) {
  System fast = system, reference = system;
  const bool compare = loops.threads() == 1;
  reference.kernel = Kernel::reference;
  if (compare) prepare(reference);
  const int fast_steps = steps_in_batch(fast, loops);
  const int reference_steps = compare ? steps_in_batch(reference, loops) : 0;
  PassSeconds best{1e300, 1e300};
  double best_reference = 1e300;
  for (int batch = 0; batch < kBatches; ++batch) {
    if (compare) best_reference = std::min(best_reference, time_steps(reference, loops, reference_steps).sum());
    const PassSeconds now = time_steps(fast, loops, fast_steps);
    if (now.sum() < best.sum()) best = now;
  }
  const auto n = static_cast<double>(system.particles.triangle_count());
  const auto edges = static_cast<double>(system.contacts.size());
  StepCost cost;
  cost.triangles = system.particles.triangle_count();
  cost.contact_points = 2 * system.contacts.size();
  cost.threads = loops.threads();
  if (compare) cost.reference_ns = 1e9 * best_reference / n;
  cost.fast_ns = 1e9 * best.sum() / n;
  cost.fast_contact_ns = 1e9 * best.forces / (2.0 * edges);
  cost.fast_motion_ns = 1e9 * best.motion / n;
  cost.bytes_per_triangle = static_cast<double>(memory_of(fast)) / n;
  cost.flops_per_triangle = kTriangleFlops + kEdgeFlops * edges / n;
  cost.traffic_per_triangle = kTriangleTraffic + kEdgeTraffic * edges / n;
  const MachinePeak peak = measure_machine_peak(loops, memory_of(fast));
  cost.peak = peak;
  cost.bound_ns = 1e9 * std::max(cost.flops_per_triangle / peak.flops, cost.traffic_per_triangle / peak.bandwidth);
  return cost;
}

}  // namespace asperity
