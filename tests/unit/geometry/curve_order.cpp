#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <vector>

#include "tests/unit/geometry/mesh_checks.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

/// Squares of side 1 in rows, cut in two; one of its own vertices each.
Mesh rows_of_squares(int n) {
  Mesh mesh;
  for (int i = 0; i < n * n; ++i) {
    const double x = i % n, y = i / n;
    const int v = static_cast<int>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}});
    mesh.triangles.insert(mesh.triangles.end(), {{v, v + 1, v + 2}, {v, v + 2, v + 3}});
    mesh.grain.insert(mesh.grain.end(), {i, i});
  }
  return mesh;
}

}  // namespace

TEST_CASE("along the Hilbert curve each square is followed by one that shares a side with it") {
  const Mesh sorted = sort_along_curve(rows_of_squares(16));
  std::vector<std::array<int, 2>> cells;
  for (const auto& [a, b, c] : sorted.triangles) {
    const Vec2 centroid = (1.0 / 3.0) * (sorted.vertices[a] + sorted.vertices[b] + sorted.vertices[c]);
    const std::array<int, 2> cell{static_cast<int>(centroid.x), static_cast<int>(centroid.y)};
    if (cells.empty() || cells.back() != cell) cells.push_back(cell);
  }
  REQUIRE(cells.size() == 256);
  for (std::size_t i = 1; i < cells.size(); ++i)
    CHECK(std::abs(cells[i][0] - cells[i - 1][0]) + std::abs(cells[i][1] - cells[i - 1][1]) == 1);
}

TEST_CASE("vertices and grains are numbered as the triangles first name them") {
  for (ParticleKind kind : {ParticleKind::triangle, ParticleKind::voronoi}) {
    const Mesh mesh = make_mesh(disc_experiment(), particles(kind, 2.0, 3));
    int vertices = 0, grains = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (int v : mesh.triangles[t]) {
        CHECK(v <= vertices);
        vertices = std::max(vertices, v + 1);
      }
      CHECK(mesh.grain[t] <= grains);
      grains = std::max(grains, mesh.grain[t] + 1);
    }
    CHECK(vertices == static_cast<int>(mesh.vertices.size()));
  }
}

TEST_CASE("sorting twice changes nothing, and a vertex without triangle is dropped") {
  Mesh mesh = rows_of_squares(4);
  mesh.vertices.push_back({2.0, 2.0});
  const Mesh once = sort_along_curve(mesh);
  CHECK(once.vertices.size() == 64);
  CHECK(same_bytes(once, sort_along_curve(once)));
}

TEST_CASE("neighbours in the plane are neighbours in memory") {
  const Mesh mesh = make_mesh(rectangle_experiment(), particles(ParticleKind::triangle, 2.0, 1));
  int near = 0, all = 0;
  for (const MeshEdge& e : mesh_edges(mesh)) {
    if (e.right < 0) continue;
    ++all;
    if (e.right - e.left < 64) ++near;
  }
  // A numbering by rows would have a third of them here, a random one 3 %.
  CHECK(near > 0.75 * all);
}
