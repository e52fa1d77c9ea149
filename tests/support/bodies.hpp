#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/models.hpp"

/// Several bodies in one mesh, each an elastic continuum (one grain) made of triangles, for contact problems.
namespace asperity::test {

/// A mesh under construction; body i is grain i.
struct Bodies {
  Mesh mesh;
  int count = 0;

  /// Adds a body from its own vertices and triangles; returns its number.
  int add(const std::vector<Vec2>& vertices, const std::vector<std::array<int, 3>>& triangles) {
    const int first = static_cast<int>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), vertices.begin(), vertices.end());
    for (const auto& t : triangles) {
      mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
      mesh.grain.push_back(count);
    }
    return count++;
  }

  /// A block of columns x rows cells, lower left corner at `origin`, turned about it by `angle` (rad).
  int add_block(Vec2 origin, const Grid& grid, double angle = 0.0) {
    Mesh block = grid_mesh(grid);
    for (Vec2& v : block.vertices) v = origin + turned(v, angle);
    return add(block.vertices, block.triangles);
  }

  /// A block of columns x rows cells whose unit square is mapped: place({u, v}) with u, v from 0 to 1.
  template <class Place>
  int add_mapped(const Grid& grid, const Place& place) {
    Mesh block = grid_mesh(grid);
    for (Vec2& v : block.vertices) v = place(Vec2{v.x / (grid.edge * grid.columns), v.y / (grid.edge * grid.rows)});
    return add(block.vertices, block.triangles);
  }

  /// A quadrilateral of columns x rows cells with corners a, b, c, d, counter-clockwise; columns lie along ab.
  int add_quadrilateral(const std::array<Vec2, 4>& corners, const Grid& grid) {
    return add_mapped(grid, [&](Vec2 w) {
      return (1.0 - w.y) * ((1.0 - w.x) * corners[0] + w.x * corners[1]) +
             w.y * ((1.0 - w.x) * corners[3] + w.x * corners[2]);
    });
  }

  /// A regular polygon of triangles around its centre.
  int add_wheel(Vec2 centre, double radius, int corners, double angle = 0.0) {
    std::vector<Vec2> vertices{centre};
    std::vector<std::array<int, 3>> triangles;
    for (int i = 0; i < corners; ++i) {
      vertices.push_back(centre + turned({radius, 0.0}, angle + 2.0 * std::numbers::pi * i / corners));
      triangles.push_back({0, 1 + i, 1 + (i + 1) % corners});
    }
    return add(vertices, triangles);
  }
};

/// Elastic and contact constants of a contact problem; units as in the core.
struct BodyMaterial {
  double youngs_modulus = 1300.0;  ///< MPa
  double poissons_ratio = 0.2;
  double density = 1200.0;  ///< kg/m3
  SurfaceLaw surface{0.5, 2000.0, 2000.0};
  double damping_ratio = 0.0;
};

/// A system of bodies in general contact; `safety` times the stable step of bodies and contact penalties together.
inline System make_bodies(const Bodies& bodies, const BodyMaterial& material, double safety = 0.3) {
  RunConfig config = plaster();
  config.particles.youngs_modulus_gpa = material.youngs_modulus / 1000.0;
  config.particles.poissons_ratio = material.poissons_ratio;
  config.particles.density_kg_per_m3 = material.density;
  System system;
  system.particles = make_particles(bodies.mesh, config.particles, config.experiment.plane);
  system.contacts = make_contacts(bodies.mesh, system.particles, law_parameters(config), LawReading::consistent);
  GeneralContactLaw law{true, {material.surface, material.surface}, material.damping_ratio};
  system.general = make_general_contacts(system.particles, law);
  system.contacts.hand_over_range = kHandOverRange;
  prepare(system);
  system.time_step = safety * critical_time_step(system, ParallelLoops());
  return system;
}

/// The plaster's contacts between a mesh's grains, and general contact of the same friction and stiffness.
struct BondedBodies {
  Particles particles;
  BondedContacts contacts;
  GeneralContacts general;
};

inline BondedBodies bonded_bodies(const Mesh& mesh, bool general = true) {
  const RunConfig config = plaster();
  const LawParameters law = law_parameters(config);
  BondedBodies bodies;
  bodies.particles = make_particles(mesh, config.particles, config.experiment.plane);
  bodies.contacts = make_contacts(mesh, bodies.particles, law, LawReading::consistent);
  if (!general) return bodies;
  bodies.general = make_general_contacts(bodies.particles, general_contact_law(config, law));
  bodies.contacts.hand_over_range = kHandOverRange;
  return bodies;
}

/// The same, ready to move at `safety` times the stable step.
inline System bonded_system(const Mesh& mesh, double safety, bool general = true) {
  BondedBodies bodies = bonded_bodies(mesh, general);
  System system;
  system.particles = std::move(bodies.particles);
  system.contacts = std::move(bodies.contacts);
  system.general = std::move(bodies.general);
  prepare(system);
  system.time_step = safety * critical_time_step(system, ParallelLoops());
  return system;
}

/// Nodes of one body.
inline std::vector<int> nodes_of(const System& system, int body) {
  std::vector<std::uint8_t> seen(system.particles.node_count(), 0);
  std::vector<int> nodes;
  for (std::size_t t = 0; t < system.particles.triangle_count(); ++t) {
    if (system.particles.grain[t] != body) continue;
    for (int node : system.particles.triangles[t]) {
      if (!seen[node]) nodes.push_back(node);
      seen[node] = 1;
    }
  }
  return nodes;
}

/// Rigid motion of a body: mass, centre, mean velocity, angular momentum about the centre.
struct BodyMotion {
  double mass = 0;
  Vec2 centre, velocity;
  double angular_momentum = 0;
};

inline BodyMotion motion_of(const System& system, int body) {
  const Particles& p = system.particles;
  const std::vector<int> nodes = nodes_of(system, body);
  BodyMotion motion;
  for (int node : nodes) {
    motion.mass += p.mass[node];
    motion.centre += p.mass[node] * p.position[node];
    motion.velocity += p.mass[node] * p.velocity[node];
  }
  motion.centre = (1.0 / motion.mass) * motion.centre;
  motion.velocity = (1.0 / motion.mass) * motion.velocity;
  for (int node : nodes) {
    motion.angular_momentum += p.mass[node] * cross(p.position[node] - motion.centre, p.velocity[node]);
  }
  return motion;
}

inline void hold(System& system, int body, Vec2 velocity = {0, 0}) {
  if (system.held.empty()) system.held.assign(system.particles.node_count(), 0);
  for (int node : nodes_of(system, body)) {
    system.held[node] = 1;
    system.particles.velocity[node] = velocity;
  }
}

/// Net force of everything that touches a held body on it, N per mm of thickness; valid after compute_forces.
inline Vec2 force_on(const System& system, int body) {
  Vec2 sum;
  for (int node : nodes_of(system, body)) sum += internal_force(system, node);
  return sum;
}

inline void set_velocity(System& system, int body, Vec2 velocity) {
  for (int node : nodes_of(system, body)) system.particles.velocity[node] = velocity;
}

/// Largest error of the energy account over a run, over the largest external work (the initial kinetic energy counts).
struct EnergyWatch {
  double largest_error = 0, largest_work = 0;
  void see(const EnergyBalance& e) {
    largest_error = std::max(largest_error, std::abs(e.error()));
    largest_work = std::max(largest_work, std::abs(e.external_work));
  }
  double relative() const { return largest_error / largest_work; }
};

/// Steps up to a time (s) with the account watched; visit() is called after every step.
template <class Visit>
void run_until(System& system, double time, EnergyWatch& watch, const Visit& visit) {
  const ParallelLoops loops;
  while (system.time < time) {
    watch.see(advance_with_energy(system, loops));
    visit();
  }
}

inline void run_until(System& system, double time, EnergyWatch& watch) {
  run_until(system, time, watch, [] {});
}

}  // namespace asperity::test
