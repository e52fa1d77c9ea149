#include <catch2/catch.hpp>

#include "core/base/error.hpp"
#include "tests/unit/geometry/mesh_checks.hpp"

using namespace asperity;
using namespace asperity::test;

TEST_CASE("the edges of two triangles are listed by triangle and corner, with their place on the outline") {
  const std::vector<MeshEdge> edges = mesh_edges(unit_square());
  REQUIRE(edges.size() == 5);
  const auto is = [&](int i, int a, int b, int left, int right, Boundary boundary) {
    const MeshEdge& e = edges[i];
    CHECK((e.a == a && e.b == b && e.left == left && e.right == right && e.boundary == boundary));
  };
  is(0, 0, 1, 0, -1, Boundary::bottom);
  is(1, 1, 2, 0, -1, Boundary::right);
  is(2, 2, 0, 0, 1, Boundary::none);
  is(3, 2, 3, 1, -1, Boundary::top);
  is(4, 3, 0, 1, -1, Boundary::left);
}

TEST_CASE("a mesh without triangles has no edges") { CHECK(mesh_edges(Mesh{}).empty()); }

TEST_CASE("edges of three triangles and opposite orientations are refused") {
  Mesh fan = unit_square();
  fan.vertices.push_back({0.2, 0.1});
  fan.triangles.push_back({0, 2, 4});
  fan.grain.push_back(2);
  CHECK_THROWS_AS(mesh_edges(fan), Error);
  Mesh flipped = unit_square();
  flipped.triangles[1] = {0, 3, 2};
  CHECK_THROWS_AS(mesh_edges(flipped), Error);
}

TEST_CASE("every edge of a specimen has the triangles it names on its two sides") {
  const Mesh mesh = make_mesh(disc_experiment(), particles(ParticleKind::triangle, 3.0, 4));
  const auto third = [&](int t, const MeshEdge& e) {
    for (int v : mesh.triangles[t])
      if (v != e.a && v != e.b) return mesh.vertices[v];
    return Vec2{};
  };
  std::size_t sides = 0;
  for (const MeshEdge& e : mesh_edges(mesh)) {
    const Vec2 a = mesh.vertices[e.a], d = mesh.vertices[e.b] - a;
    CHECK(cross(d, third(e.left, e) - a) > 0.0);
    if (e.right >= 0) CHECK(cross(d, third(e.right, e) - a) < 0.0);
    CHECK((e.right < 0) == (e.boundary != Boundary::none));
    sides += e.right >= 0 ? 2 : 1;
  }
  CHECK(sides == 3 * mesh.triangles.size());
}
