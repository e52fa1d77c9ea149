#include "core/geometry/filling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "core/base/error.hpp"

namespace asperity {

Mesh first_success(const ParticleConfig& particles, std::string_view stream,
                   const std::function<Mesh(RandomStream&, int)>& attempt) {
  constexpr int kAttempts = 8;
  std::string reason;
  for (int k = 0; k < kAttempts; ++k) {
    RandomStream random(particles.seed, fmt::format("{}/{}", stream, k));
    try {
      return attempt(random, k);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::numerical) throw;
      reason = error.what();
    }
  }
  throw Error(ErrorKind::numerical,
              fmt::format("no mesh of the asked quality in {} attempts (seed {}, edge {} mm, "
                          "deviation {} mm): {}",
                          kAttempts, particles.seed, particles.edge_mm, particles.edge_deviation(), reason));
}

Mesh to_mesh(const PointSet& set, const Triangulation& triangulation, std::vector<int> grain, double outline_area_mm2) {
  Mesh mesh{positions(set), triangulation.triangles, std::move(grain), outline_area_mm2};
  const std::size_t points = mesh.vertices.size();
  mesh = sort_along_curve(mesh);
  if (mesh.vertices.size() != points) throw Error(ErrorKind::numerical, "a mesh point has left the specimen");
  return mesh;
}

}  // namespace asperity
