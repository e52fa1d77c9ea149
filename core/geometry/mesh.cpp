#include "core/geometry/mesh.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "core/geometry/box.hpp"

namespace asperity {
namespace {

/// One triangle's view of an edge.
struct HalfEdge {
  int low, high;  ///< Vertices, low < high.
  int triangle, corner;
};

std::vector<HalfEdge> sorted_half_edges(const Mesh& mesh) {
  std::vector<HalfEdge> halves;
  halves.reserve(3 * mesh.triangles.size());
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
      halves.push_back({low, high, t, k});
    }
  const auto key = [](const HalfEdge& h) { return std::array<int, 3>{h.low, h.high, h.triangle}; };
  std::sort(halves.begin(), halves.end(), [&](const HalfEdge& a, const HalfEdge& b) { return key(a) < key(b); });
  return halves;
}

Boundary boundary_at(Vec2 a, Vec2 b, const Box& box) {
  if (a.y == box.low.y && b.y == box.low.y) return Boundary::bottom;
  if (a.y == box.high.y && b.y == box.high.y) return Boundary::top;
  if (a.x == box.low.x && b.x == box.low.x) return Boundary::left;
  if (a.x == box.high.x && b.x == box.high.x) return Boundary::right;
  return Boundary::rim;
}

/// For each triangle's three local edges the triangle beyond, -1 on the outline.
std::vector<std::array<int, 3>> neighbours(const Mesh& mesh) {
  std::vector<std::array<int, 3>> beyond(mesh.triangles.size(), {-1, -1, -1});
  const std::vector<HalfEdge> halves = sorted_half_edges(mesh);
  const auto same = [&](std::size_t i, std::size_t j) {
    return j < halves.size() && halves[i].low == halves[j].low && halves[i].high == halves[j].high;
  };
  for (std::size_t i = 0; i < halves.size(); ++i) {
    if (!same(i, i + 1)) continue;
    const HalfEdge &a = halves[i], &b = halves[i + 1];
    if (same(i, i + 2)) throw Error(ErrorKind::numerical, "the mesh has an edge with three triangles");
    if (mesh.triangles[a.triangle][a.corner] == mesh.triangles[b.triangle][b.corner])
      throw Error(ErrorKind::numerical, "the mesh has two neighbours of opposite orientation");
    beyond[a.triangle][a.corner] = b.triangle;
    beyond[b.triangle][b.corner] = a.triangle;
    ++i;
  }
  return beyond;
}

}  // namespace

std::vector<MeshEdge> mesh_edges(const Mesh& mesh) {
  std::vector<MeshEdge> edges;
  if (mesh.triangles.empty()) return edges;
  const Box box = bounding_box(mesh.vertices);
  const std::vector<std::array<int, 3>> beyond = neighbours(mesh);
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3], right = beyond[t][k];
      if (right >= 0 && right < t) continue;
      edges.push_back(
          {a, b, t, right, right < 0 ? boundary_at(mesh.vertices[a], mesh.vertices[b], box) : Boundary::none});
    }
  return edges;
}

}  // namespace asperity
