#pragma once
#include <cmath>
#include <cstring>
#include <set>
#include <vector>

#include "core/geometry/mesh.hpp"
#include "core/geometry/specimen.hpp"

namespace asperity::test {

inline ExperimentConfig rectangle_experiment() {
  ExperimentConfig experiment;
  experiment.type = ExperimentType::uniaxial;
  return experiment;
}

inline ExperimentConfig disc_experiment() { return {}; }

inline ParticleConfig particles(ParticleKind kind, double edge_mm, std::uint64_t seed) {
  ParticleConfig p;
  p.kind = kind;
  p.edge_mm = edge_mm;
  p.edge_deviation_mm = 0.1 * edge_mm;
  p.seed = seed;
  return p;
}

inline double triangle_area(const Mesh& mesh, const std::array<int, 3>& t) {
  return 0.5 * cross(mesh.vertices[t[1]] - mesh.vertices[t[0]], mesh.vertices[t[2]] - mesh.vertices[t[0]]);
}

inline bool all_counter_clockwise(const Mesh& mesh) {
  for (const auto& t : mesh.triangles)
    if (triangle_area(mesh, t) <= 0.0) return false;
  return true;
}

/// V - E + F; 1 for a simply connected triangulation.
inline int euler_characteristic(const Mesh& mesh) {
  return static_cast<int>(mesh.vertices.size()) - static_cast<int>(mesh_edges(mesh).size()) +
         static_cast<int>(mesh.triangles.size());
}

inline bool same_bytes(const Mesh& a, const Mesh& b) {
  const auto same = [](const auto& u, const auto& v) {
    return u.size() == v.size() && std::memcmp(u.data(), v.data(), u.size() * sizeof(u[0])) == 0;
  };
  return same(a.vertices, b.vertices) && same(a.triangles, b.triangles) && same(a.grain, b.grain);
}

/// Length of the mesh's outline by label, mm.
inline double outline_length(const Mesh& mesh, Boundary boundary) {
  double length = 0.0;
  for (const MeshEdge& e : mesh_edges(mesh))
    if (e.boundary == boundary) length += norm(mesh.vertices[e.b] - mesh.vertices[e.a]);
  return length;
}

/// Two triangles, a unit square: x in [-0.5, 0.5], y in [0, 1].
inline Mesh unit_square() { return {{{-0.5, 0}, {0.5, 0}, {0.5, 1}, {-0.5, 1}}, {{0, 1, 2}, {0, 2, 3}}, {0, 1}}; }

}  // namespace asperity::test
