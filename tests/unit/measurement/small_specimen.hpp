#pragma once
#include <array>
#include <vector>

#include "core/contact/bonded_contacts.hpp"
#include "core/particles/particles.hpp"

namespace asperity::testing {

/// A specimen that can be counted by hand: squares on a grid, each cut into two triangles by its rising diagonal. Its
/// bottom is y = 0, its middle x = 0. Square (column, row) has the triangles 2 (row columns + column), below the
/// diagonal, and the next one, above it.
struct SmallSpecimen {
  Mesh mesh;
  Particles particles;
  BondedContacts contacts;
};

inline Mesh grid_mesh(int columns, int rows, double side) {
  Mesh mesh;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) mesh.vertices.push_back({(i - 0.5 * columns) * side, j * side});
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int v = j * (columns + 1) + i;
      mesh.triangles.push_back({v, v + 1, v + columns + 2});
      mesh.triangles.push_back({v, v + columns + 2, v + columns + 1});
    }
  }
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) mesh.grain.push_back(t);
  return mesh;
}

inline SmallSpecimen specimen_of(const Mesh& mesh) {
  SmallSpecimen s{mesh, make_particles(mesh, ParticleConfig{}, PlaneCondition::stress), {}};
  s.contacts =
      make_contacts(s.mesh, s.particles, LawParameters{}, LawReading::literal);  // keeps tractions as they are set
  return s;
}

inline SmallSpecimen small_specimen(int columns, int rows, double side = 1.0) {
  return specimen_of(grid_mesh(columns, rows, side));
}

/// Index of the contact between two triangles; -1 if they do not touch.
inline int contact_between(const BondedContacts& contacts, int t, int u) {
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const ContactEdge& e = contacts.edges[c];
    if ((e.left_triangle() == t && e.right_triangle() == u) || (e.left_triangle() == u && e.right_triangle() == t)) {
      return static_cast<int>(c);
    }
  }
  return -1;
}

/// Breaks both points of a contact; `energy` is what each spent, N/mm.
inline void break_contact(BondedContacts& contacts, int c, BreakMode mode, double time, double energy = 1.0) {
  std::array<PointState, 2> points = contacts.points(c);
  for (PointState& point : points) {
    point.broken = mode;
    point.damage = 1.0;
    point.fracture_energy = energy;
  }
  contacts.set_points(c, points);
  contacts.broken_edge(c).break_time = time;
}

}  // namespace asperity::testing
