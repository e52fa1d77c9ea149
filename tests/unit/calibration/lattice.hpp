#pragma once
#include <cmath>

#include "core/contact/closed_forms.hpp"
#include "core/integrator/static_stiffness.hpp"

namespace asperity::testing {

/// A rectangle of equilateral triangles with horizontal rows and halved triangles along straight flanks.
class Lattice {
 public:
  Lattice(int columns, int rows, double edge) : columns_(columns), rows_(rows), edge_(edge) {
    for (int row = 0; row <= rows; ++row) add_vertices(row);
    for (int row = 0; row < rows; ++row) add_triangles(row);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) mesh_.grain.push_back(static_cast<int>(t));
  }

  const Mesh& mesh() const { return mesh_; }
  double row_height() const { return 0.5 * std::sqrt(3.0) * edge_; }
  /// The whole triangle with its base down that stands i-th in a row.
  int upright(int row, int i) const { return uprights_[row][i]; }

 private:
  static bool even(int row) { return row % 2 == 0; }

  void add_vertices(int row) {
    first_.push_back(static_cast<int>(mesh_.vertices.size()));
    const double y = row * row_height();
    mesh_.vertices.push_back({0.0, y});
    for (int i = even(row) ? 1 : 0; i < columns_; ++i)
      mesh_.vertices.push_back({(i + (even(row) ? 0.0 : 0.5)) * edge_, y});
    mesh_.vertices.push_back({columns_ * edge_, y});
  }

  void add_triangles(int row) {
    // The full row has the vertices 0, 1, ... n edges apart, the other one begins and ends with half an edge.
    const bool full_below = even(row);
    const int full = first_[full_below ? row : row + 1], halved = first_[full_below ? row + 1 : row];
    const auto add = [&](int a, int b, int c) {
      if (full_below)
        mesh_.triangles.push_back({a, b, c});
      else
        mesh_.triangles.push_back({b, a, c});
    };
    uprights_.emplace_back();
    for (int i = 0; i < columns_; ++i) {
      if (full_below) uprights_.back().push_back(static_cast<int>(mesh_.triangles.size()));
      add(full + i, full + i + 1, halved + i + 1);
    }
    for (int i = 0; i <= columns_; ++i) {
      if (!full_below) uprights_.back().push_back(static_cast<int>(mesh_.triangles.size()));
      add(halved + i + 1, halved + i, full + i);
    }
  }

  int columns_, rows_;
  double edge_;
  Mesh mesh_;
  std::vector<int> first_;
  std::vector<std::vector<int>> uprights_;
};

/// Moves a lattice's particles by the elastic solution under a uniform axial stress on its ends; the flanks are free.
inline System compressed(const Lattice& lattice, const ParticleConfig& particles, PlaneCondition plane,
                         const LawParameters& law, double stress) {
  System system;
  system.particles = make_particles(lattice.mesh(), particles, plane);
  system.contacts = make_contacts(lattice.mesh(), system.particles, law, LawReading::consistent);
  system.platens.y = {-1e9, 1e9};
  prepare(system);
  const PointStiffness initial{law.k_t, law.k_s};
  const StaticStiffness stiffness(system, std::vector<EdgeStiffness>(system.contacts.size(), {initial, initial}));
  std::vector<Vec2> force(system.particles.node_count());
  for (const MeshEdge& e : mesh_edges(lattice.mesh())) {
    if (e.boundary != Boundary::bottom && e.boundary != Boundary::top) continue;
    const double half = 0.5 * stress * norm(lattice.mesh().vertices[e.b] - lattice.mesh().vertices[e.a]);
    for (int node : system.particles.triangles[e.left]) {
      if (system.particles.vertex[node] != e.a && system.particles.vertex[node] != e.b) continue;
      force[node].y += e.boundary == Boundary::bottom ? half : -half;
    }
  }
  const std::vector<Vec2> moved = stiffness.solve(force);
  for (std::size_t i = 0; i < moved.size(); ++i) system.particles.position[i] += moved[i];
  return system;
}

/// Displacement of a triangle's centroid.
inline Vec2 displacement(const System& system, int triangle) {
  Vec2 sum;
  for (int node : system.particles.triangles[triangle]) {
    sum += system.particles.position[node] - system.particles.reference(node);
  }
  return (1.0 / 3.0) * sum;
}

}  // namespace asperity::testing
