#include "core/experiment/step_benchmark.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include "core/base/random.hpp"
#include "core/experiment/model.hpp"

namespace asperity {
namespace {

constexpr int kBatches = 9;
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

/// Bytes: an edge reads its description and memory (friction energy apart), writes what changes while it hardens and
/// opens, and its two slots twice over (a line is fetched before it is written); a triangle reads positions for the
/// contacts and for itself, slots, their indices, shape and masses, reads and writes velocities, reads them again for
/// the positions, which it reads and writes.
constexpr double kPointRows = 9, kWrittenRows = 7;
constexpr double kEdgeTraffic = sizeof(ContactEdge) + sizeof(int) + 2 * 8 * (kPointRows + kWrittenRows) + 2 * 64;
constexpr double kTriangleTraffic = 2 * 48 + 96 + 12 + 40 + 24 + 2 * 48 + 48 + 2 * 48;

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
    update_velocities(system, loops);
    update_positions(system, loops);
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
         bytes(c.memory.literal) + bytes(c.broken_index) + bytes(c.broken) + bytes(c.slot_of_edge) +
         bytes(c.strengths) + bytes(g.members) + bytes(g.wear) + bytes(g.rubbing) + bytes(g.pairs) +
         bytes(g.chain_contacts) + bytes(g.handing_over) + bytes(g.touches) + bytes(g.frames) + bytes(g.forces) +
         bytes(g.set_free) + bytes(g.alive) + bytes(s.flank.edges) + bytes(s.flank.outline) + bytes(s.held) +
         bytes(s.platen_springs.nodes) + bytes(s.platen_springs.springs) + bytes(s.platen_shear) + bytes(s.forces) +
         bytes(s.loads.nodes) + bytes(s.loads.forces) + bytes(s.loads.places) + bytes(s.gather.begin) +
         bytes(s.gather.index);
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

namespace {

/// One kernel on one number of threads: its own copy of the system, and the best batch so far.
struct Contestant {
  System system;
  const ParallelLoops& loops;
  int steps = 0;
  PassSeconds best{1e300, 1e300};

  Contestant(const System& model, const ParallelLoops& threads, Kernel kernel) : system(model), loops(threads) {
    system.kernel = kernel;
    prepare(system);
    steps = steps_in_batch(system, loops);
  }

  void run_batch() {
    const PassSeconds now = time_steps(system, loops, steps);
    if (now.sum() < best.sum()) best = now;
  }
};

PassCosts pass_costs(const Contestant& c) {
  const auto n = static_cast<double>(c.system.particles.triangle_count());
  const auto points = 2.0 * static_cast<double>(c.system.contacts.size());
  return {1e9 * c.best.sum() / n, 1e9 * c.best.forces / points, 1e9 * c.best.motion / n, 1e6 * c.best.sum()};
}

StepCost cost_of(const Contestant& fast) {
  const auto n = static_cast<double>(fast.system.particles.triangle_count());
  const auto edges = static_cast<double>(fast.system.contacts.size());
  StepCost cost;
  cost.triangles = fast.system.particles.triangle_count();
  cost.contact_points = 2 * fast.system.contacts.size();
  cost.threads = fast.loops.threads();
  cost.fast = pass_costs(fast);
  cost.bytes_per_triangle = static_cast<double>(memory_of(fast.system)) / n;
  cost.flops_per_triangle = kTriangleFlops + kEdgeFlops * edges / n;
  cost.traffic_per_triangle = kTriangleTraffic + kEdgeTraffic * edges / n;
  cost.peak = measure_machine_peak(fast.loops, memory_of(fast.system));
  cost.bound_ns =
      1e9 * std::max(cost.flops_per_triangle / cost.peak.flops, cost.traffic_per_triangle / cost.peak.bandwidth);
  return cost;
}

}  // namespace

std::vector<StepCost> measure_step(const System& system, const std::vector<int>& thread_counts) {
  std::vector<std::unique_ptr<ParallelLoops>> loops;
  for (int threads : thread_counts) loops.push_back(std::make_unique<ParallelLoops>(threads));
  const ParallelLoops one;
  std::vector<std::unique_ptr<Contestant>> contestants;
  contestants.push_back(std::make_unique<Contestant>(system, one, Kernel::reference));
  for (const auto& threads : loops) contestants.push_back(std::make_unique<Contestant>(system, *threads, Kernel::fast));
  for (int batch = 0; batch < kBatches; ++batch) {
    for (const auto& contestant : contestants) contestant->run_batch();
  }
  std::vector<StepCost> costs;
  for (std::size_t i = 1; i < contestants.size(); ++i) {
    costs.push_back(cost_of(*contestants[i]));
    if (costs.back().threads == 1) costs.back().reference = pass_costs(*contestants[0]);
  }
  return costs;
}

}  // namespace asperity
