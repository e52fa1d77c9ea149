#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/vec2.hpp"

namespace asperity {

/// Which part of the specimen's outline an edge lies on.
enum class Boundary : std::uint8_t { none, bottom, top, left, right, rim };

/// A conforming triangulation of the specimen: vertices are shared, triangles counter-clockwise. Lengths in mm.
/// Rectangle: x in [-width/2, width/2], y in [0, height]. Disc: centre at (0, radius), so both rest on y = 0.
struct Mesh {
  std::vector<Vec2> vertices;
  std::vector<std::array<int, 3>> triangles;  ///< Vertex indices.
  std::vector<int> grain;                     ///< Grain of each triangle; its own index where every triangle is a particle.
};

/// An edge of the triangulation between vertices a and b; triangle `left` lies to the left of a -> b.
struct MeshEdge {
  int a, b;
  int left, right;    ///< Triangles; right is -1 on the outline.
  Boundary boundary;  ///< none inside.
};

/// All edges, ordered by (left triangle, local edge), every interior edge once.
std::vector<MeshEdge> mesh_edges(const Mesh& mesh);

/// Edge lengths and angles over all triangles, in mm and degrees.
struct MeshQuality {
  int triangles = 0, vertices = 0, grains = 0;
  double edge_mean_mm = 0, edge_deviation_mm = 0, edge_min_mm = 0, edge_max_mm = 0;
  double angle_min_deg = 0, area_mm2 = 0, outline_area_mm2 = 0;
};

}  // namespace asperity
