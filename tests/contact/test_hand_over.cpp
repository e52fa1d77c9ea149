#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/heaps.hpp"
#include "tests/support/sliders.hpp"

using namespace asperity;

namespace {

const ParallelLoops kLoops;
constexpr int kSurfaceEdges = 8;

const double kTanPhi = law_parameters(test::plaster()).tan_phi;
constexpr double kEdge = 2.0;  ///< Mean length of the surface's edges, mm.

/// The block stands on edges `first` ... `first + count - 1` of the surface and shares their vertices.
Mesh bonded_mesh(int first, int count) {
  const std::vector<double> lengths = test::irregular_lengths(kSurfaceEdges, kEdge, 11);
  test::Bodies bodies;
  test::add_strip(bodies, {0.0, -2.0}, lengths, 1, 2.0);
  double x = 0;
  for (int i = 0; i < first; ++i) x += lengths[i];
  const std::vector<double> widths(lengths.begin() + first, lengths.begin() + first + count);
  const int block = test::add_strip(bodies, {x, 0.0}, widths, 1, 1.8);
  const int on_top = kSurfaceEdges + 1 + first, under = 2 * (kSurfaceEdges + 1);
  for (std::size_t t = 0; t < bodies.mesh.triangles.size(); ++t) {
    if (bodies.mesh.grain[t] != block) continue;
    for (int& v : bodies.mesh.triangles[t]) {
      if (v >= under && v <= under + count) v = on_top + v - under;
    }
  }
  return bodies.mesh;
}

/// A block bonded with the plaster's contacts to a longer surface of irregular edges; the surface is body 0.
System bonded_block(int edges, double safety) {
  const Mesh mesh = bonded_mesh(1, edges);
  const RunConfig config = test::plaster();
  const LawParameters law = law_parameters(config);
  System system;
  system.particles = make_particles(mesh, config.particles, config.experiment.plane);
  system.contacts = make_contacts(mesh, system.particles, law, LawReading::consistent);
  const SurfaceLaw surface{law.tan_phi, law.k_t, law.k_s};
  system.general = make_general_contacts(mesh, system.contacts, system.particles, {true, {surface, surface}, 0.0});
  system.contacts.hand_over_range = kHandOverRange;
  prepare(system);
  system.time_step = safety * critical_time_step(system, kLoops);
  return system;
}

/// Gives the block's held nodes a velocity; the energy that puts in counts as work.
void drive(System& system, Vec2 velocity) {
  for (int node : test::nodes_of(system, 1)) {
    if (!system.held[node]) continue;
    Vec2& v = system.particles.velocity[node];
    system.initial_kinetic += 0.5 * system.particles.mass[node] * (dot(velocity, velocity) - dot(v, v));
    v = velocity;
  }
}

/// Moves the block's held nodes in a straight line; `see` is called with the forces known.
template <class See>
void move(System& system, Vec2 by, double speed, const See& see) {
  const int steps = static_cast<int>(std::ceil(norm(by) / (speed * system.time_step)));
  drive(system, (1.0 / (steps * system.time_step)) * by);
  for (int i = 0; i < steps; ++i) {
    compute_forces(system, kLoops);
    update_velocities(system, kLoops);
    see();
    update_positions(system, kLoops);
  }
}

int broken(const BondedContacts& contacts) {
  return static_cast<int>(std::count_if(contacts.break_time.begin(), contacts.break_time.end(),
                                        [](double time) { return time >= 0.0; }));
}

int released(const BondedContacts& contacts) {
  return static_cast<int>(std::count_if(contacts.hand_over.begin(), contacts.hand_over.end(),
                                        [](const HandOver& h) { return h.weight == 0.0; }));
}

/// What a passage showed; forces count from the moment all bonded contacts have broken.
struct Passage {
  test::EnergyWatch energy;
  double jump = 0, largest = 0;        ///< Of the force between two steps, and of the force, N per mm.
  double least_friction = 1e9;         ///< |F_x| / F_y once the block is pressed.
  int broken = 0, released = 0;        ///< At the end.
  BreakMode mode = BreakMode::none;    ///< Of the first contact.
  Vec2 before;
  bool watching = false;

  void see(const System& system) {
    energy.see(energy_balance(system, kLoops));
    broken = ::broken(system.contacts);
    released = ::released(system.contacts);
    if (broken < static_cast<int>(system.contacts.size())) return;
    mode = edge_break_mode(system.contacts.points[0]);
    const Vec2 force = test::force_on(system, 1);
    if (watching) jump = std::max(jump, norm(force - before));
    largest = std::max(largest, norm(force));
    before = force;
    watching = true;
  }
};

enum class Way { shear, tension };

/// How a block is broken off and slid on.
struct Trial {
  Way way;
  int edges;         ///< Bonded.
  bool rigid;        ///< All its nodes are led; else the upper ones.
  double speed;      ///< mm/s
  double step = 1;   ///< Factor on the time step.
};

/// Break by shear under pressure, or by tension and close again 0.8 mm aside; then slide over three edges.
Passage pass(const Trial& trial) {
  System system = bonded_block(trial.edges, 0.2 * trial.step);
  test::hold(system, 0);
  for (int node : test::nodes_of(system, 1)) {
    if (trial.rigid || system.particles.reference[node].y > 1.0) system.held[node] = 1;
  }
  if (!trial.rigid) system.local_damping = 0.4;
  Passage passage;
  const auto see = [&] { passage.see(system); };
  const double depth = 0.002;
  if (trial.way == Way::shear) {
    move(system, {0, -depth}, 0.05 * trial.speed, see);
  } else {
    move(system, {0, 1.5}, trial.speed, see);
    move(system, {0.8, 0}, trial.speed, see);
    move(system, {0, 0.02 - 1.5}, trial.speed, see);
    move(system, {0, -0.02 - depth}, 0.05 * trial.speed, see);
  }
  const double start = system.particles.position[test::nodes_of(system, 1)[0]].x;
  move(system, {3.0 * kEdge, 0}, trial.speed, [&] {
    see();
    const double x = system.particles.position[test::nodes_of(system, 1)[0]].x - start;
    if (!passage.watching || x < 0.02 * kEdge) return;
    const Vec2 force = passage.before;
    passage.least_friction = std::min(passage.least_friction, -force.x / force.y);
  });
  return passage;
}

/// The passage at a step of motion and at half of it: a force without jumps changes half as much in half a step.
void check_passage(const Trial& trial) {
  const Passage whole = pass(trial);
  Trial finer = trial;
  // Led nodes move by speed times step; inertia would ask for other motions at another speed.
  (trial.rigid ? finer.speed : finer.step) *= 0.5;
  const Passage half = pass(finer);
  CAPTURE(trial.edges, trial.rigid, whole.jump, half.jump, whole.largest, whole.energy.relative());
  CHECK(whole.mode == (trial.way == Way::shear ? BreakMode::shear : BreakMode::tension));
  for (const Passage* p : {&whole, &half}) {
    CHECK(p->broken == trial.edges);
    CHECK(p->released == trial.edges);
    CHECK(p->energy.relative() < 1e-3);
  }
  CHECK(half.jump < 0.6 * whole.jump);
  if (trial.rigid) {
    // Bonded and general contact share the pressure, and each rubs at its limit.
    CHECK(whole.least_friction > 0.95 * kTanPhi);
    CHECK(half.least_friction > 0.95 * kTanPhi);
  }
  WARN((trial.rigid ? "led, " : "elastic, ")
       << trial.edges << " edges: energy error " << whole.energy.relative() << ", largest jump " << whole.jump
       << " N/mm, at half the step " << half.jump << ", of " << whole.largest << "; least friction "
       << whole.least_friction);
}

/// 2,400 triangles bonded as single particles in a held box, torn apart by their velocities.
System torn_assembly(double speed, bool general, double safety = 0.3) {
  const test::Grid grid{40, 30};
  test::Bodies bodies;
  test::add_box(bodies, 84.0, 20);
  const Mesh pieces = test::grid_mesh(grid);
  const int first = static_cast<int>(bodies.mesh.vertices.size());
  for (Vec2 v : pieces.vertices) bodies.mesh.vertices.push_back(v + Vec2{2.0, 2.0});
  for (std::size_t t = 0; t < pieces.triangles.size(); ++t) {
    const auto& v = pieces.triangles[t];
    bodies.mesh.triangles.push_back({first + v[0], first + v[1], first + v[2]});
    bodies.mesh.grain.push_back(1 + pieces.grain[t]);
  }
  const RunConfig config = test::plaster();
  const LawParameters law = law_parameters(config);
  System system;
  system.particles = make_particles(bodies.mesh, config.particles, config.experiment.plane);
  system.contacts = make_contacts(bodies.mesh, system.particles, law, LawReading::consistent);
  if (general) {
    const SurfaceLaw surface{law.tan_phi, law.k_t, law.k_s};
    system.general =
        make_general_contacts(bodies.mesh, system.contacts, system.particles, {true, {surface, surface}, 0.0});
    system.contacts.hand_over_range = kHandOverRange;
  }
  prepare(system);
  system.time_step = safety * critical_time_step(system, kLoops);
  test::scatter_velocities(system, speed);
  test::hold(system, 0);
  book_initial_kinetic_energy(system);
  return system;
}

}  // namespace

TEST_CASE("A bonded block broken in shear slides past its edges to the next partners without a jump") {
  check_passage({Way::shear, 1, true, 4000.0});
  check_passage({Way::shear, 2, true, 4000.0});
  check_passage({Way::shear, 1, false, 1000.0});
}

TEST_CASE("A bonded block broken in tension closes again at another place and slides on without a jump") {
  check_passage({Way::tension, 1, true, 4000.0});
  check_passage({Way::tension, 2, false, 1000.0});
}

TEST_CASE("An assembly torn apart keeps its energy account, and is bitwise the same on 1, 2 and 4 threads") {
  std::vector<Vec2> positions, velocities;
  for (int threads : {1, 2, 4}) {
    const ParallelLoops loops(threads);
    System system = torn_assembly(2e4, true);
    test::EnergyWatch energy;
    for (int step = 0; step < 400; ++step) {
      compute_forces(system, loops);
      update_velocities(system, loops);
      if (threads == 1 && step % 10 == 0) energy.see(energy_balance(system, loops));
      update_positions(system, loops);
    }
    if (threads == 1) {
      CHECK(energy.relative() < 1e-3);
      CHECK(system.general.touches.size() > 2 * ParallelLoops::kBlock);
      CHECK(system.general.pairs.size() > 4 * ParallelLoops::kBlock);
      CHECK(released(system.contacts) > 1000);
      WARN("energy error " << energy.relative() << ", " << system.general.touches.size() << " touches, "
                           << system.general.pairs.size() << " pairs, " << broken(system.contacts) << " of "
                           << system.contacts.size() << " contacts broken, " << released(system.contacts)
                           << " released, deepest " << system.general.largest_depth << " mm");
      positions = system.particles.position;
      velocities = system.particles.velocity;
    }
    CAPTURE(threads);
    CHECK(system.particles.position == positions);
    CHECK(system.particles.velocity == velocities);
  }
}

TEST_CASE("Without general contact an assembly moves as before it existed; with it, an unbroken one does too") {
  System without = torn_assembly(2e4, false), off = torn_assembly(2e4, true);
  off.general.law.enabled = false;
  off.contacts.hand_over_range = 0.0;
  off.time_step = without.time_step;
  test::advance(without, kLoops, 200);
  test::advance(off, kLoops, 200);
  CHECK(broken(without.contacts) > 1000);
  CHECK(off.particles.position == without.particles.position);
  CHECK(off.general.touches.empty());

  System still = torn_assembly(1.0, false), still_on = torn_assembly(1.0, true);
  still_on.time_step = still.time_step;
  test::advance(still, kLoops, 200);
  test::advance(still_on, kLoops, 200);
  CHECK(broken(still.contacts) == 0);
  CHECK(still_on.particles.position == still.particles.position);
}
