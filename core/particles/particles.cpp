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
        particles.reference.push_back(mesh.vertices[vertex]);
      }
      nodes[i] = entry->second;
    }
    particles.triangles.push_back(nodes);
  }
}

}  // namespace

Particles make_particles(const Mesh& mesh, const ParticleConfig& config, PlaneCondition plane) {
  Particles particles;
  particles.elastic = elastic_constants(config.youngs_modulus_gpa * units::kMpaPerGpa, config.poissons_ratio, plane);
  particles.grain = mesh.grain;
  number_nodes(mesh, particles);
  particles.position = particles.reference;
  particles.velocity.assign(particles.node_count(), {});
  particles.mass.assign(particles.node_count(), 0.0);
  const double density = config.density_kg_per_m3 * units::kTonnePerMm3PerKgPerM3;
  for (const auto& nodes : particles.triangles) {
    particles.shapes.push_back(
        triangle_shape(particles.reference[nodes[0]], particles.reference[nodes[1]], particles.reference[nodes[2]]));
    for (int node : nodes) particles.mass[node] += density * particles.shapes.back().area / 3.0;
  }
  return particles;
}

double triangle_energy(const Particles& particles, std::size_t t) {
  const TriangleShape& shape = particles.shapes[t];
  return shape.area * biot_state(deformation_gradient(shape, particles.corners(t)), particles.elastic).energy_density();
}

std::array<double, 4> triangle_stress(const Particles& particles, std::size_t t) {
  const DeformationGradient f = deformation_gradient(particles.shapes[t], particles.corners(t));
  return cauchy_stress(f, biot_state(f, particles.elastic), particles.elastic);
}

}  // namespace asperity
