#pragma once
#include <array>
#include <vector>

#include "core/base/vec2.hpp"
#include "core/config/run_config.hpp"
#include "core/geometry/mesh.hpp"
#include "core/particles/elasticity.hpp"

namespace asperity {

/// The deformable particles: nodes that belong to one particle alone, and constant-strain triangles between them.
/// Lengths mm, velocities mm/s, masses tonne per mm of thickness. Velocities belong to the half step before the
/// positions.
struct Particles {
  std::vector<Vec2> reference, position, velocity;
  std::vector<double> mass;
  std::vector<int> vertex;  ///< Mesh vertex of each node.
  std::vector<std::array<int, 3>> triangles;
  std::vector<TriangleShape> shapes;
  std::vector<int> grain;
  ElasticConstants elastic;

  std::size_t node_count() const { return position.size(); }
  std::size_t triangle_count() const { return triangles.size(); }
  std::array<Vec2, 3> corners(std::size_t t) const {
    const auto& n = triangles[t];
    return {position[n[0]], position[n[1]], position[n[2]]};
  }
};

/// Particles at rest on a mesh: one node for every pair of grain and vertex, a third of each triangle's mass on each
/// corner.
Particles make_particles(const Mesh& mesh, const ParticleConfig& config, PlaneCondition plane);

/// Elastic energy of one triangle (N mm per mm of thickness), Eq. (P3).
double triangle_energy(const Particles& particles, std::size_t triangle);

/// Cauchy stress (xx, yy, zz, xy; MPa, tension positive) of one triangle, Eq. (P5).
std::array<double, 4> triangle_stress(const Particles& particles, std::size_t triangle);

}  // namespace asperity
