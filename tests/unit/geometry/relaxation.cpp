#include "core/geometry/relaxation.hpp"

#include <catch2/catch.hpp>

using namespace asperity;

namespace {

/// Fixed points joined to a ring.
PointSet ring(const std::vector<Vec2>& corners) {
  PointSet set;
  const int n = static_cast<int>(corners.size());
  for (const Vec2& p : corners) set.points.push_back({p, Freedom::fixed});
  for (int i = 0; i < n; ++i) set.segments.push_back({i, (i + 1) % n});
  return set;
}

}  // namespace

TEST_CASE("angles in sharp corners do not count") {
  PointSet set = ring({{0, 0}, {4, 0}, {4, 1}});  // 14, 76 and 90 degrees.
  const Triangulation mesh = triangulate(positions(set), set.segments);
  CHECK(measure_regularity(set, mesh).angle_min_deg == Approx(14.036).epsilon(1e-4));
  mark_sharp_corners(set, 25.0);
  CHECK(set.points[0].sharp);
  CHECK_FALSE(set.points[1].sharp);
  CHECK_FALSE(set.points[2].sharp);
  CHECK(measure_regularity(set, mesh).angle_min_deg == Approx(75.964).epsilon(1e-4));
}

TEST_CASE("corners are sharp between any two segments, also across the direction of -x") {
  PointSet set = ring({{0, 0}, {-4, 0.5}, {-4, -0.5}});
  mark_sharp_corners(set, 25.0);
  CHECK(set.points[0].sharp);
  CHECK_FALSE(set.points[1].sharp);
}

TEST_CASE("a point squeezed against a side is dropped, one in the middle is not") {
  PointSet set = ring({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  set.points.push_back({{1.0, 1.0}});
  CHECK_FALSE(drop_squeezed(set, triangulate(positions(set), set.segments), 25.0));
  set.points.back().at = {1.0, 0.1};
  CHECK(drop_squeezed(set, triangulate(positions(set), set.segments), 25.0));
  CHECK(set.points.size() == 4);
}

TEST_CASE("a point that has left is dropped, fixed ones stay") {
  PointSet set = ring({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  set.points.push_back({{1.0, -1.0}});
  set.points.push_back({{3.0, 1.0}, Freedom::fixed});
  CHECK(drop_squeezed(set, triangulate(positions(set), set.segments), 25.0));
  REQUIRE(set.points.size() == 5);
  CHECK(set.points.back().at == Vec2{3.0, 1.0});
}
