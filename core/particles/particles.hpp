#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/base/vec2.hpp"
#include "core/config/run_config.hpp"
#include "core/geometry/mesh.hpp"
#include "core/particles/elasticity.hpp"

namespace asperity {

/// Shapes of eight triangles, field by field: gradients of the second and third shape function (1/mm) and area (mm2).
/// The first gradient is minus the sum of the others.
struct alignas(64) PackedShapes {
  static constexpr std::size_t kSize = 8;
  using Row = std::array<double, kSize>;
  Row g1x, g1y, g2x, g2y, area;
};

/// What eight triangles that may yield remember, field by field: plastic strain, Eq. (P7), and the work it took, N/mm2.
struct alignas(64) PackedPlasticity {
  PackedShapes::Row difference, shear, work;
};

/// The deformable particles: nodes that belong to one particle alone, and constant-strain triangles between them.
/// Lengths mm, velocities mm/s, masses tonne per mm of thickness. Velocities belong to the half step before the
/// positions.
struct Particles {
  std::vector<Vec2> position, velocity;
  std::vector<double> mass;
  std::vector<int> vertex;     ///< Mesh vertex of each node.
  std::vector<Vec2> vertices;  ///< The mesh's, where nodes are at rest.
  std::vector<std::array<int, 3>> triangles;
  std::vector<PackedShapes> shapes;
  std::vector<int> grain;
  ElasticConstants elastic;
  ElasticConstants bulk;                     ///< Of the triangles that stand for the intact material.
  std::vector<std::uint8_t> in_bulk;         ///< 1: such a triangle; empty: there are none.
  std::vector<PackedPlasticity> plasticity;  ///< Empty: particles do not yield.
  double half_yield = 0;  ///< MPa, half of Y of Eq. (P7); triangles of the intact material do not yield.
  bool separate = false;  ///< Every triangle is a particle, and its nodes are 3 t, 3 t + 1, 3 t + 2.

  const ElasticConstants& elastic_of(std::size_t t) const { return in_bulk.empty() || !in_bulk[t] ? elastic : bulk; }
  bool yields(std::size_t t) const { return !plasticity.empty() && (in_bulk.empty() || !in_bulk[t]); }
  PlasticStrain plastic(std::size_t t) const {
    if (plasticity.empty()) return {};
    const PackedPlasticity& block = plasticity[t / PackedShapes::kSize];
    return {block.difference[t % PackedShapes::kSize], block.shear[t % PackedShapes::kSize]};
  }
  std::size_t node_count() const { return position.size(); }
  std::size_t triangle_count() const { return triangles.size(); }
  std::array<Vec2, 3> corners(std::size_t t) const {
    const auto& n = triangles[t];
    return {position[n[0]], position[n[1]], position[n[2]]};
  }
  Vec2 reference(std::size_t node) const { return vertices[vertex[node]]; }
  TriangleShape shape(std::size_t t) const {
    const PackedShapes& block = shapes[t / PackedShapes::kSize];
    const std::size_t i = t % PackedShapes::kSize;
    const Vec2 g1{block.g1x[i], block.g1y[i]}, g2{block.g2x[i], block.g2y[i]};
    return {{Vec2{} - (g1 + g2), g1, g2}, block.area[i]};
  }
};

/// Particles at rest on a mesh: one node for every pair of grain and vertex, a third of each triangle's mass on each
/// corner.
Particles make_particles(const Mesh& mesh, const ParticleConfig& config, PlaneCondition plane);

/// Lets particles yield at a largest difference of in-plane principal stresses, MPa; Eq. (P7). Call once.
void set_yield_stress(Particles& particles, double yield_stress_mpa);

/// Biot state of one triangle at the present positions, with its plastic strain as it is.
BiotState triangle_state(const Particles& particles, std::size_t triangle);

/// Work spent on plastic strain in one triangle so far, N mm per mm of thickness; Eq. (P7).
double plastic_work(const Particles& particles, std::size_t triangle);

/// The state at the present positions after the triangle has yielded, which is kept.
BiotState update_triangle(Particles& particles, std::size_t triangle);

/// Elastic energy of one triangle (N mm per mm of thickness), Eq. (P3).
double triangle_energy(const Particles& particles, std::size_t triangle);

/// Cauchy stress (xx, yy, zz, xy; MPa, tension positive) of one triangle, Eq. (P5).
std::array<double, 4> triangle_stress(const Particles& particles, std::size_t triangle);

}  // namespace asperity
