#pragma once
#include <cmath>
#include <functional>
#include <string_view>
#include <vector>

#include "core/base/random.hpp"
#include "core/config/run_config.hpp"
#include "core/geometry/mesh.hpp"
#include "core/geometry/outline.hpp"
#include "core/geometry/points.hpp"
#include "core/geometry/relaxation.hpp"

namespace asperity {

/// Irregular triangles of edge_mm and at most 1.25 edge_deviation_mm (standard deviation), no angle below 25 degrees;
/// each is a grain. Throws Error(numerical) with seed and figures where eight attempts fail.
Mesh triangle_mesh(const Outline& outline, const ParticleConfig& particles);

/// Voronoi grains of mean diameter grain_size_mm, each cut into at least two triangles of about edge_mm, no angle below
/// 10 degrees. Throws Error(numerical) with seed and figures where eight attempts fail.
Mesh voronoi_mesh(const Outline& outline, const ParticleConfig& particles);

/// Tries attempt(random, k) for k = 0..7 with a stream of its own each, and passes on the first mesh made; an attempt
/// gives up by throwing Error(numerical). When all do, throws one that names the seed and the last one's reason.
Mesh first_success(const ParticleConfig& particles, std::string_view stream,
                   const std::function<Mesh(RandomStream&, int)>& attempt);

/// The relaxed points as a mesh ordered along the curve; grain[t] is triangle t's grain, under any numbers below the
/// number of triangles. Throws Error(numerical) where a point is left over.
Mesh to_mesh(const PointSet& set, const Triangulation& triangulation, std::vector<int> grain, double outline_area_mm2);

/// Eq. (G1): triangles of mean edge length edge_mm that fill an area, were they all equilateral.
inline double equilateral_count(double area_mm2, double edge_mm) {
  return 4.0 * area_mm2 / (std::sqrt(3.0) * edge_mm * edge_mm);
}

}  // namespace asperity
