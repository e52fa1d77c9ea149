#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "core/base/units.hpp"
#include "core/geometry/mesh.hpp"

namespace asperity {
namespace {

/// Eq. (G8).
void add_lengths(const Mesh& mesh, const std::vector<MeshEdge>& edges, MeshQuality& q) {
  double sum = 0.0, squares = 0.0;
  q.edge_min_mm = std::numeric_limits<double>::infinity();
  for (const MeshEdge& edge : edges) {
    const double length = norm(mesh.vertices[edge.b] - mesh.vertices[edge.a]);
    sum += length;
    q.edge_min_mm = std::min(q.edge_min_mm, length);
    q.edge_max_mm = std::max(q.edge_max_mm, length);
  }
  q.edge_mean_mm = sum / static_cast<double>(edges.size());
  for (const MeshEdge& edge : edges) {
    const double d = norm(mesh.vertices[edge.b] - mesh.vertices[edge.a]) - q.edge_mean_mm;
    squares += d * d;
  }
  q.edge_deviation_mm = std::sqrt(squares / static_cast<double>(edges.size()));
}

/// Eq. (G9), and the area.
void add_angles(const Mesh& mesh, MeshQuality& q) {
  q.angle_min_deg = 180.0;
  for (const auto& triangle : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const Vec2 corner = mesh.vertices[triangle[k]];
      const Vec2 u = mesh.vertices[triangle[(k + 1) % 3]] - corner, v = mesh.vertices[triangle[(k + 2) % 3]] - corner;
      const double angle = std::atan2(cross(u, v), dot(u, v)) / units::kRadPerDeg;
      q.angle_min_deg = std::min(q.angle_min_deg, angle);
      q.angle_max_deg = std::max(q.angle_max_deg, angle);
      if (k == 0) q.area_mm2 += 0.5 * cross(u, v);
    }
  }
}

/// Eq. (G10).
double bond_order(const Mesh& mesh, const std::vector<MeshEdge>& edges) {
  std::complex<double> sum = 0.0;
  for (const MeshEdge& edge : edges) {
    const Vec2 d = mesh.vertices[edge.b] - mesh.vertices[edge.a];
    sum += std::polar(1.0, 6.0 * std::atan2(d.y, d.x));
  }
  return std::abs(sum) / static_cast<double>(edges.size());
}

double sixfold_fraction(const Mesh& mesh, const std::vector<MeshEdge>& edges) {
  std::vector<int> valence(mesh.vertices.size(), 0);
  std::vector<bool> outer(mesh.vertices.size(), false);
  for (const MeshEdge& edge : edges)
    for (int v : {edge.a, edge.b}) {
      ++valence[v];
      if (edge.right < 0) outer[v] = true;
    }
  double inner = 0.0, sixfold = 0.0;
  for (std::size_t v = 0; v < valence.size(); ++v) {
    if (outer[v]) continue;
    inner += 1.0;
    if (valence[v] == 6) sixfold += 1.0;
  }
  return inner > 0.0 ? sixfold / inner : 0.0;
}

}  // namespace

MeshQuality measure_quality(const Mesh& mesh) {
  MeshQuality q;
  if (mesh.triangles.empty()) return q;
  const std::vector<MeshEdge> edges = mesh_edges(mesh);
  q.triangles = static_cast<int>(mesh.triangles.size());
  q.vertices = static_cast<int>(mesh.vertices.size());
  q.grains = mesh.grain.empty() ? 0 : 1 + *std::max_element(mesh.grain.begin(), mesh.grain.end());
  q.edges = static_cast<int>(edges.size());
  q.outline_edges =
      static_cast<int>(std::count_if(edges.begin(), edges.end(), [](const MeshEdge& e) { return e.right < 0; }));
  add_lengths(mesh, edges, q);
  add_angles(mesh, q);
  q.outline_area_mm2 = mesh.outline_area_mm2;
  if (q.outline_area_mm2 > 0.0) q.area_error = (q.outline_area_mm2 - q.area_mm2) / q.outline_area_mm2;
  q.bond_order = bond_order(mesh, edges);
  q.sixfold_fraction = sixfold_fraction(mesh, edges);
  return q;
}

}  // namespace asperity
