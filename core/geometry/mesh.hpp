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
  std::vector<int> grain;       ///< Grain of each triangle; its own index where every triangle is a particle.
  double outline_area_mm2 = 0;  ///< Of the outline itself, which a disc's polygon falls short of; 0: unknown.
};

/// An edge of the triangulation between vertices a and b; triangle `left` lies to the left of a -> b.
struct MeshEdge {
  int a, b;
  int left, right;    ///< Triangles; right is -1 on the outline.
  Boundary boundary;  ///< none inside.
};

/// All edges, ordered by (left triangle, local edge k from corner k to k + 1), every interior edge once. An edge of the
/// outline is named by its place: both ends exactly at the least or greatest y or x of the mesh, else rim. Throws
/// Error(numerical) where three triangles share an edge or two that do are not both counter-clockwise.
std::vector<MeshEdge> mesh_edges(const Mesh& mesh);

/// Edge lengths and angles over all triangles, in mm and degrees; defined in README.md.
struct MeshQuality {
  int triangles = 0, vertices = 0, grains = 0;
  int edges = 0, outline_edges = 0;
  double edge_mean_mm = 0, edge_deviation_mm = 0, edge_min_mm = 0, edge_max_mm = 0;  ///< Eq. (G8), every edge once.
  double angle_min_deg = 0, angle_max_deg = 0;                                       ///< Eq. (G9).
  double area_mm2 = 0, outline_area_mm2 = 0;
  double area_error = 0;        ///< (outline - mesh) / outline; 0 where the outline's area is unknown.
  double bond_order = 0;        ///< Eq. (G10): 1 for a hexagonal crystal, near 0 for an isotropic arrangement.
  double sixfold_fraction = 0;  ///< Of the vertices inside: the share with exactly six edges; 1 for a crystal.
};

MeshQuality measure_quality(const Mesh& mesh);

/// The triangles in the order of a Hilbert curve through their centroids.
std::vector<int> curve_order(const Mesh& mesh);

/// Renumbers triangles in their curve_order, and vertices and grains in the order in which the triangles first name
/// them: neighbours in the plane become neighbours in memory. Drops vertices no triangle names.
Mesh sort_along_curve(const Mesh& mesh);

}  // namespace asperity
