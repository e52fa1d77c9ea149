#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

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
System bonded_block(int edges, double safety) { return test::bonded_system(bonded_mesh(1, edges), safety); }

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

/// What a passage showed; forces count from the moment all bonded contacts have broken.
struct Passage {
  test::EnergyWatch energy;
  double jump = 0, largest = 0;      ///< Of the force between two steps, and of the force, N per mm.
  double least_friction = 1e9;       ///< |F_x| / F_y once the block is pressed.
  int broken = 0, released = 0;      ///< At the end.
  BreakMode mode = BreakMode::none;  ///< Of the first contact.
  Vec2 before;
  bool watching = false;

  void see(const System& system) {
    energy.see(energy_balance(system, kLoops));
    broken = test::broken(system.contacts);
    released = test::released(system.contacts);
    if (broken < static_cast<int>(system.contacts.size())) return;
    mode = edge_break_mode(system.contacts.points(0));
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
  int edges;        ///< Bonded.
  bool rigid;       ///< All its nodes are led; else the upper ones.
  double speed;     ///< mm/s
  double step = 1;  ///< Factor on the time step.
};

/// Break by shear under pressure, or by tension and close again 0.8 mm aside; then slide over three edges.
Passage pass(const Trial& trial) {
  System system = bonded_block(trial.edges, 0.2 * trial.step);
  test::hold(system, 0);
  for (int node : test::nodes_of(system, 1)) {
    if (trial.rigid || system.particles.reference(node).y > 1.0) system.held[node] = 1;
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

/// Six particles around a vertex without friction, all their contacts broken and handing over.
System handing_over_wheel(RandomStream& random) {
  test::Bodies bodies;
  bodies.add_wheel({0, 0}, kEdge, 6, 0.1);
  for (int t = 0; t < 6; ++t) bodies.mesh.grain[t] = t;
  const RunConfig config = test::plaster();
  LawParameters law = law_parameters(config);
  law.tan_phi = law.tan_phi_peak = 0.0;
  System system;
  system.particles = make_particles(bodies.mesh, config.particles, config.experiment.plane);
  system.contacts = make_contacts(bodies.mesh, system.particles, law, LawReading::consistent);
  const SurfaceLaw surface{0.0, 1.7 * law.k_t, law.k_s};
  system.general = make_general_contacts(system.particles, {true, {surface, surface}, 0});
  system.contacts.hand_over_range = kHandOverRange;
  prepare(system);
  system.time_step = 0.2 * critical_time_step(system, kLoops);
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    test::break_in_shear(system.contacts, c);
    system.contacts.broken_edge(c).break_time = 0.0;
  }
  const double reach = 0.3 * kHandOverRange * kEdge;
  for (Vec2& x : system.particles.position) x += Vec2{random.uniform(-reach, reach), random.uniform(-reach, reach)};
  return system;
}

/// All energy at the present positions, with fresh lists.
double stored_energy(System system) {
  system.general.search_due = 1;
  compute_forces(system, kLoops);
  return elastic_energy(system.particles, kLoops) + contact_energies(system.contacts, kLoops).recoverable +
         general_contact_energies(system.general, kLoops).normal;
}

}  // namespace

TEST_CASE("Forces of contacts handing over are the gradient of the energy that bonded and general contacts share") {
  RandomStream random(1, "handing over");
  const double h = 1e-7;
  double worst = 0, shared = 0;
  for (int trial = 0; trial < 60; ++trial) {
    System system = handing_over_wheel(random);
    compute_forces(system, kLoops);
    System at = system;       // which knows the seats
    at.general.play = kEdge;  // and lets none yield while the slope is taken
    double size = 0;
    for (std::size_t i = 0; i < system.particles.node_count(); ++i) {
      size = std::max(size, norm(internal_force(system, i)));
    }
    for (const Touch& touch : system.general.touches) shared = std::max(shared, touch.weight * (1.0 - touch.weight));
    for (std::size_t i = 0; i < system.particles.node_count(); ++i) {
      for (double Vec2::*component : {&Vec2::x, &Vec2::y}) {
        System up = at, down = at;
        up.particles.position[i].*component += h;
        down.particles.position[i].*component -= h;
        const double slope = (stored_energy(up) - stored_energy(down)) / (2.0 * h);
        worst = std::max(worst, std::abs(internal_force(system, i).*component + slope) / size);
      }
    }
  }
  CHECK(shared > 0.2);  // some touches were half way
  CHECK(worst < 1e-5);
  WARN("largest error of a force " << worst << " of the largest");
}

TEST_CASE("A bonded block broken in shear slides past its edges to the next partners without a jump") {
  check_passage({Way::shear, 1, true, 4000.0});
  check_passage({Way::shear, 2, true, 4000.0});
  check_passage({Way::shear, 1, false, 1000.0});
}

TEST_CASE("A bonded block broken in tension closes again at another place and slides on without a jump") {
  check_passage({Way::tension, 1, true, 4000.0});
  check_passage({Way::tension, 2, false, 1000.0});
}
