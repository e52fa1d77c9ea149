#pragma once
#include <algorithm>
#include <vector>

#include "core/base/random.hpp"
#include "core/contact/closed_forms.hpp"
#include "core/integrator/system.hpp"
#include "core/integrator/time_step.hpp"

/// Small models for tests of the core, made without CGAL: a jittered grid of triangles and the plaster's constants.
namespace asperity::test {

/// Cells are squares of `edge` mm cut along a random diagonal; inner vertices move by up to `jitter` edges.
struct Grid {
  int columns, rows;
  double edge = 2.0;
  double jitter = 0.2;
};

inline Mesh grid_mesh(const Grid& grid) {
  RandomStream random(7, "test grid");
  Mesh mesh;
  for (int j = 0; j <= grid.rows; ++j) {
    for (int i = 0; i <= grid.columns; ++i) {
      const bool inside = i > 0 && j > 0 && i < grid.columns && j < grid.rows;
      const double reach = inside ? grid.jitter : 0.0;
      const double x = i + random.uniform(-reach, reach);
      mesh.vertices.push_back({grid.edge * x, grid.edge * (j + random.uniform(-reach, reach))});
    }
  }
  for (int j = 0; j < grid.rows; ++j) {
    for (int i = 0; i < grid.columns; ++i) {
      const int a = j * (grid.columns + 1) + i, b = a + 1, d = a + grid.columns + 1, c = d + 1;
      const bool rising = random.uniform() < 0.5;
      mesh.triangles.push_back(rising ? std::array{a, b, c} : std::array{a, b, d});
      mesh.triangles.push_back(rising ? std::array{a, c, d} : std::array{b, c, d});
    }
  }
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) mesh.grain.push_back(t);
  return mesh;
}

/// The same mesh as one grain: all nodes shared, no contacts, an elastic continuum.
inline Mesh continuum(Mesh mesh) {
  mesh.grain.assign(mesh.triangles.size(), 0);
  return mesh;
}

/// Table 5 of the paper: what a config that says nothing means.
inline RunConfig plaster(PlaneCondition plane = PlaneCondition::stress) {
  RunConfig config;
  config.experiment.plane = plane;
  return config;
}

/// A law of the plaster's stiffness that stays linear: strengths so large that displacements of millimetres are
/// nothing.
inline LawParameters unbreakable_law() {
  RunConfig config = plaster();
  config.contacts.tensile_strength_mpa = config.contacts.cohesion_mpa = 1e12;
  config.contacts.fracture_energy_n_per_mm = 1e25;
  return law_parameters(config);
}

inline System make_system(const Mesh& mesh, const RunConfig& config, const LawParameters& law) {
  System system;
  system.particles = make_particles(mesh, config.particles, config.experiment.plane);
  system.contacts = make_contacts(mesh, system.particles, law, config.contacts.law.reading, config.contacts.law.form);
  prepare(system);
  system.time_step = 0.5 * critical_time_step(system, ParallelLoops());
  return system;
}

inline System make_system(const Mesh& mesh, const RunConfig& config = plaster()) {
  return make_system(mesh, config, law_parameters(config));
}

/// Changes both points of a contact.
template <class Change>
void change_points(BondedContacts& contacts, std::size_t c, const Change& change) {
  std::array<PointState, 2> points = contacts.points(c);
  for (PointState& s : points) change(s);
  contacts.set_points(c, points);
}

/// Both points sheared through before the start; their pair keeps its weight.
inline void break_in_shear(BondedContacts& contacts, std::size_t c) {
  change_points(contacts, c, [](PointState& s) {
    s.integrity_n = s.integrity_s = 0.0;
    s.damage = 1.0;
    s.broken = BreakMode::shear;
  });
}

inline void advance(System& system, const ParallelLoops& loops, int steps = 1) {
  for (int i = 0; i < steps; ++i) {
    compute_forces(system, loops);
    update_velocities(system, loops);
    update_positions(system, loops);
  }
}

/// Forces, velocities and the energies of the present instant, then the step; the account is not valid elsewhere.
inline EnergyBalance advance_with_energy(System& system, const ParallelLoops& loops) {
  compute_forces(system, loops);
  update_velocities(system, loops);
  const EnergyBalance energy = energy_balance(system, loops);
  update_positions(system, loops);
  return energy;
}

/// Velocities that differ from particle to particle by about `speed` mm/s: enough of it tears every contact.
inline void scatter_velocities(System& system, double speed) {
  RandomStream random(3, "test velocities");
  for (const auto& nodes : system.particles.triangles) {
    const Vec2 common{speed * random.normal(), speed * random.normal()};
    for (int node : nodes) {
      system.particles.velocity[node] = common + Vec2{0.1 * speed * random.normal(), 0.1 * speed * random.normal()};
    }
  }
}

/// How many contacts have broken, and how many of them have passed over to general contact.
inline int broken(const BondedContacts& contacts) {
  return static_cast<int>(
      std::count_if(contacts.broken.begin(), contacts.broken.end(), [](const auto& b) { return b.break_time >= 0.0; }));
}

inline int released(const BondedContacts& contacts) {
  return static_cast<int>(std::count_if(contacts.broken.begin(), contacts.broken.end(),
                                        [](const auto& b) { return b.hand_over.weight == 0.0; }));
}

inline Vec2 turned(Vec2 a, double angle) {
  return {std::cos(angle) * a.x - std::sin(angle) * a.y, std::sin(angle) * a.x + std::cos(angle) * a.y};
}

}  // namespace asperity::test
