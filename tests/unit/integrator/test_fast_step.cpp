
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "core/base/instruction_set.hpp"
#include "tests/support/models.hpp"

using namespace asperity;

namespace {

const ParallelLoops kLoops;

/// Triangles as particles between flat platens or curved jaws, or grains of two that share nodes, half of them of
/// another elasticity, between flat platens; or the first and the last with particles that yield.
enum class Kind { flat, curved, grains, yielding, yielding_grains };

/// A block that takes two nodes along, and elastic grains.
void add_grain_parts(System& system) {
  Particles& p = system.particles;
  p.bulk = elastic_constants(900.0, 0.1, PlaneCondition::strain);
  p.in_bulk.resize(p.triangle_count());
  for (std::size_t t = 0; t < p.triangle_count(); ++t) p.in_bulk[t] = t / 2 % 3 == 0;
  RigidBlock block;
  block.nodes = {120, 121};
  for (int node : block.nodes) block.mass += p.mass[node];
  block.free_along_y = true;
  system.blocks = {block};
  system.block_of.assign(p.node_count(), -1);
  for (int node : block.nodes) system.block_of[node] = 0;
}

/// Cells of bonded triangles between platens with friction, under damping, some nodes held, some loaded.
System busy_system(Kernel kernel, Kind kind) {
  Mesh mesh = test::grid_mesh({9, 7});  // 126 triangles: the last register is not full
  const bool curved = kind == Kind::curved, grains = kind == Kind::grains || kind == Kind::yielding_grains;
  const bool yielding = kind == Kind::yielding || kind == Kind::yielding_grains;
  for (std::size_t t = 0; grains && t < mesh.grain.size(); ++t) mesh.grain[t] = static_cast<int>(t / 2);
  const RunConfig config = test::plaster();
  System system;
  system.particles = make_particles(mesh, config.particles, config.experiment.plane);
  system.contacts = make_contacts(mesh, system.particles, law_parameters(config), LawReading::consistent);
  system.kernel = kernel;
  if (grains) add_grain_parts(system);
  if (yielding) set_yield_stress(system.particles, 3.0);
  prepare(system);
  system.time_step = 0.5 * critical_time_step(system, kLoops);
  system.local_damping = 0.4;
  system.platens.present = true;
  system.platens.y = {0.01, 13.99};
  system.platens.velocity = system.platens.last_velocity = {400.0, -400.0};
  system.platens.friction = 0.3;
  if (curved) {  // its ends pass the arcs at the corners
    system.platens.jaw = {30.0, 9.0, 9.0, 30.0 - std::sqrt(900.0 - 81.0)};
    system.platens.y = {-1.2, 15.2};
  }
  system.platen_springs.other = {500.0, 0.0};
  system.held.assign(system.particles.node_count(), 0);
  for (std::size_t node : {100, 101, 102, 250}) system.held[node] = 1;
  system.flank.pressure = 3.0;
  for (int t : {5, 60, 125}) {
    const auto& n = system.particles.triangles[t];
    system.flank.edges.push_back({{n[0], n[1]}, 0.5});
  }
  test::scatter_velocities(system, 1e4);
  return system;
}

/// Largest distance of velocities, over the speed.
double velocity_difference(const System& a, const System& b) {
  double worst = 0.0;
  for (std::size_t i = 0; i < a.particles.node_count(); ++i) {
    worst = std::max(worst, norm(a.particles.velocity[i] - b.particles.velocity[i]) / 1e4);
  }
  return worst;
}

/// The same, and the sums over their size.
double difference(const System& a, const System& b) {
  double worst = velocity_difference(a, b);
  const auto compare = [&](double x, double y) {
    if (y != 0.0) worst = std::max(worst, std::abs(x / y - 1.0));
  };
  compare(a.sums.kinetic, b.sums.kinetic);
  compare(a.sums.damping, b.sums.damping);
  compare(a.sums.reaction[0], b.sums.reaction[0]);
  compare(a.sums.work_after, b.sums.work_after);
  compare(a.sums.platen_energy, b.sums.platen_energy);
  compare(a.sums.fastest, b.sums.fastest);
  return worst;
}

double all_plastic_work(const System& system) {
  double work = 0.0;
  for (std::size_t t = 0; t < system.particles.triangle_count(); ++t) work += plastic_work(system.particles, t);
  return work;
}

bool same_bytes(const System& a, const System& b) {
  const auto same = [](const std::vector<Vec2>& x, const std::vector<Vec2>& y) {
    return std::memcmp(x.data(), y.data(), x.size() * sizeof(Vec2)) == 0;
  };
  return same(a.particles.position, b.particles.position) && same(a.particles.velocity, b.particles.velocity) &&
         std::memcmp(&a.sums, &b.sums, sizeof a.sums) == 0 && all_plastic_work(a) == all_plastic_work(b) &&
         a.external_work == b.external_work && a.damping_energy == b.damping_energy &&
         a.contacts.broken_index == b.contacts.broken_index;
}

System after_steps(int steps, Kind kind) {
  System system = busy_system(Kernel::fast, kind);
  test::advance(system, kLoops, steps);
  return system;
}

}  // namespace

TEST_CASE("a step of the fast kernel is that of the reference, to rounding") {
  const Kind kind = GENERATE(Kind::flat, Kind::curved, Kind::grains, Kind::yielding, Kind::yielding_grains);
  System fast = busy_system(Kernel::fast, kind), reference = busy_system(Kernel::reference, kind);
  for (System* system : {&fast, &reference}) {
    compute_forces(*system, kLoops);
    update_velocities(*system, kLoops);
  }
  CHECK(fast.sums.reaction[0] > 0.0);
  CHECK(fast.sums.work_after != 0.0);
  const double first = difference(fast, reference);
  WARN("one step, fast against reference: " << first);
  CHECK(first < 1e-12);
  update_positions(fast, kLoops);
  update_positions(reference, kLoops);
  test::advance(fast, kLoops, 19);
  test::advance(reference, kLoops, 19);
  const bool yielding = kind == Kind::yielding || kind == Kind::yielding_grains;
  CHECK((all_plastic_work(reference) > 0.0) == yielding);
  CHECK(all_plastic_work(fast) == Approx(all_plastic_work(reference)).epsilon(1e-10));
  const double later = velocity_difference(fast, reference);
  WARN("twenty steps: " << later);
  CHECK(later < 1e-10);
}

TEST_CASE("every instruction set gives the same bytes") {
  const Kind kind = GENERATE(Kind::flat, Kind::curved, Kind::grains, Kind::yielding, Kind::yielding_grains);
  const System best = after_steps(200, kind);
  const bool yielding = kind == Kind::yielding || kind == Kind::yielding_grains;  // which spares contacts
  CHECK(best.contacts.broken.size() > (yielding ? 10 : 20));                      // otherwise nothing was tried
  CHECK((all_plastic_work(best) > 0.0) == yielding);
  const std::vector<InstructionSet> sets = instruction_sets();
  for (const InstructionSet& set : sets) {
    const ForcedInstructionSet forced(set);
    INFO(set.name);
    CHECK(same_bytes(after_steps(200, kind), best));
  }
  WARN(sets.size() << " instruction sets give the same bytes");
  CHECK(sets.size() >= 2);
}
