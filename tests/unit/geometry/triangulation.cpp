#include "core/geometry/triangulation.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "core/base/error.hpp"
#include "core/geometry/relaxation.hpp"

using namespace asperity;

TEST_CASE("segments cut the triangulation off at a notch and split it into regions") {
  // An L: the unit square's upper right quarter is outside; a border runs through it.
  const std::vector<Vec2> points{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  const Triangulation mesh = triangulate(points, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}, {0, 3}});
  CHECK(mesh.triangles.size() == 4);
  CHECK(std::set<int>(mesh.region.begin(), mesh.region.end()) == std::set<int>{0, 1});
  int edges = 0, open = 0;
  for_each_edge(mesh, [&](int, int) { ++edges; });
  for (const auto& beyond : mesh.neighbours)
    for (int t : beyond) open += t < 0;
  CHECK(edges == 9);
  CHECK(open == 6);
}

TEST_CASE("crossing segments and coinciding points are refused") {
  const std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  CHECK_THROWS_AS(triangulate(square, {{0, 2}, {1, 3}}), Error);
  CHECK_THROWS_AS(triangulate({{0, 0}, {1, 0}, {1, 1}, {0, 0}}, {{0, 1}}), Error);
}

TEST_CASE("the plain Delaunay triangulation covers the convex hull") {
  const Triangulation mesh = delaunay({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0.9}});
  CHECK(mesh.triangles.size() == 4);
}

TEST_CASE("smoothing moves a free point to the middle of its square") {
  PointSet set;
  for (const Vec2& corner : {Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1}, Vec2{0, 1}})
    set.points.push_back({corner, Freedom::fixed});
  set.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  set.points.push_back({{0.2, 0.3}});
  const Relaxed relaxed = smooth(set, 60);
  CHECK(set.points[4].at.x == Approx(0.5).margin(1e-6));
  CHECK(set.points[4].at.y == Approx(0.5).margin(1e-6));
  CHECK(relaxed.regularity.angle_min_deg == Approx(45.0).margin(1e-3));
}
