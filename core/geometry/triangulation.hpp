#pragma once
#include <array>
#include <vector>

#include "core/base/vec2.hpp"

namespace asperity {

/// Triangles of a point set with their neighbours; only those inside the outline.
struct Triangulation {
  std::vector<std::array<int, 3>> triangles;   ///< Point indices, counter-clockwise.
  std::vector<std::array<int, 3>> neighbours;  ///< Across the edge opposite to the same corner; -1 on the outline.
  std::vector<int> region;                     ///< Regions are separated by constrained segments; 0..n-1.
};

/// Calls visit(a, b) once for every edge.
template <class Visit>
void for_each_edge(const Triangulation& mesh, const Visit& visit) {
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    for (int k = 0; k < 3; ++k)
      if (mesh.neighbours[t][k] < t) visit(mesh.triangles[t][(k + 1) % 3], mesh.triangles[t][(k + 2) % 3]);
}

/// Constrained Delaunay triangulation of the points, in which every segment (a pair of point indices) is an edge, cut
/// off at the segments that close the specimen off from the outside. The same points give the same triangles in the
/// same order. Throws Error(numerical) where two segments cross or two points coincide.
Triangulation triangulate(const std::vector<Vec2>& points, const std::vector<std::array<int, 2>>& segments);

/// Plain Delaunay triangulation of the points' convex hull, as one region.
Triangulation delaunay(const std::vector<Vec2>& points);

}  // namespace asperity
