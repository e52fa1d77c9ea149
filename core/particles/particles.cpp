#include "core/particles/particles.hpp"

#include <map>
#include <utility>

#include "core/base/units.hpp"

namespace asperity {
namespace {

/// Node of each triangle corner: created in the triangles' order, shared within a grain.
void number_nodes(const Mesh& mesh, Particles& particles) {
  std::map<std::pair<int, int>, int> node_of;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<int, 3> nodes{};
    for (int i = 0; i < 3; ++i) {
      const int vertex = mesh.triangles[t][i];
      const auto [entry, added] =
          node_of.try_emplace({mesh.grain[t], vertex}, static_cast<int>(particles.vertex.size()));
      if (added) {
        particles.vertex.push_back(vertex);
      }
      nodes[i] = entry->second;
    }
    particles.triangles.push_back(nodes);
  }
}

/// Whether node 3 t + k is corner k of triangle t, and of no other.
bool nodes_are_separate(const Particles& particles) {
  if (particles.vertex.size() != 3 * particles.triangles.size()) return false;
  for (int t = 0; t < static_cast<int>(particles.triangles.size()); ++t) {
    if (particles.triangles[t] != std::array{3 * t, 3 * t + 1, 3 * t + 2}) return false;
  }
  return true;
}

void pack_shape(Particles& particles, std::size_t t, const TriangleShape& shape) {
  PackedShapes& block = particles.shapes[t / PackedShapes::kSize];
  const std::size_t i = t % PackedShapes::kSize;
  block.g1x[i] = shape.gradient[1].x;
  block.g1y[i] = shape.gradient[1].y;
  block.g2x[i] = shape.gradient[2].x;
  block.g2y[i] = shape.gradient[2].y;
  block.area[i] = shape.area;
}

}  // namespace

Particles make_particles(const Mesh& mesh, const ParticleConfig& config, PlaneCondition plane) {
  Particles particles;
  particles.elastic = elastic_constants(config.youngs_modulus_gpa * units::kMpaPerGpa, config.poissons_ratio, plane);
  particles.grain = mesh.grain;
  particles.vertices = mesh.vertices;
  number_nodes(mesh, particles);
  particles.separate = nodes_are_separate(particles);
  const std::size_t nodes = particles.vertex.size();
  for (std::size_t i = 0; i < nodes; ++i) particles.position.push_back(particles.reference(i));
  particles.velocity.assign(nodes, {});
  particles.mass.assign(nodes, 0.0);
  particles.shapes.assign((mesh.triangles.size() + PackedShapes::kSize - 1) / PackedShapes::kSize, PackedShapes{});
  const double density = config.density_kg_per_m3 * units::kTonnePerMm3PerKgPerM3;
  for (std::size_t t = 0; t < particles.triangles.size(); ++t) {
    const auto& n = particles.triangles[t];
    const TriangleShape shape =
        triangle_shape(particles.reference(n[0]), particles.reference(n[1]), particles.reference(n[2]));
    pack_shape(particles, t, shape);
    for (int node : n) particles.mass[node] += density * shape.area / 3.0;
  }
  return particles;
}

void set_yield_stress(Particles& particles, double yield_stress_mpa) {
  particles.half_yield = 0.5 * yield_stress_mpa;
  particles.plasticity.assign(particles.shapes.size(), PackedPlasticity{});
}

BiotState triangle_state(const Particles& particles, std::size_t t) {
  const DeformationGradient f = deformation_gradient(particles.shape(t), particles.corners(t));
  return biot_state(f, particles.elastic_of(t), particles.plastic(t));
}

double plastic_work(const Particles& particles, std::size_t t) {
  if (particles.plasticity.empty()) return 0.0;
  return particles.shape(t).area * particles.plasticity[t / PackedShapes::kSize].work[t % PackedShapes::kSize];
}

BiotState update_triangle(Particles& particles, std::size_t t) {
  BiotState state = triangle_state(particles, t);
  if (!particles.yields(t)) return state;
  PackedPlasticity& block = particles.plasticity[t / PackedShapes::kSize];
  const std::size_t i = t % PackedShapes::kSize;
  PlasticStrain plastic = particles.plastic(t);
  block.work[i] += yield(state, plastic, particles.elastic_of(t), particles.half_yield);
  block.difference[i] = plastic.difference;
  block.shear[i] = plastic.shear;
  return state;
}

double triangle_energy(const Particles& particles, std::size_t t) {
  return particles.shape(t).area * triangle_state(particles, t).energy_density();
}

std::array<double, 4> triangle_stress(const Particles& particles, std::size_t t) {
  const DeformationGradient f = deformation_gradient(particles.shape(t), particles.corners(t));
  return cauchy_stress(f, triangle_state(particles, t), particles.elastic_of(t));
}

}  // namespace asperity
