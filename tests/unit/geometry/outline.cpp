#include <catch2/catch.hpp>
#include <numbers>

#include "core/geometry/points.hpp"
#include "core/geometry/specimen.hpp"

using namespace asperity;

TEST_CASE("an outline is a closed chain that has the specimen on its left") {
  for (const Outline& outline : {outline_of(Rectangle{54.0, 130.0}), outline_of(Disc{54.0})}) {
    const std::size_t n = outline.sides.size();
    for (std::size_t s = 0; s < n; ++s) {
      const Side& side = outline.sides[s];
      CHECK(side.at(side.length()) == outline.sides[(s + 1) % n].start);
      CHECK(side.at(0.0) == side.start);
      const Vec2 middle = side.at(0.5 * side.length()), inward = Vec2{0.0, 27.0} - middle;
      CHECK(cross(side.tangent(0.5 * side.length()), inward) > 0.0);
    }
  }
}

TEST_CASE("outline areas") {
  CHECK(outline_of(Rectangle{54.0, 130.0}).area_mm2 == 7020.0);
  CHECK(outline_of(Disc{54.0}).area_mm2 == Approx(std::numbers::pi * 27.0 * 27.0));
}

TEST_CASE("the nearest point of a side") {
  const Outline square = outline_of(Rectangle{2.0, 2.0});
  const OutlinePoint right = nearest_on(square, {0.9, 0.5});
  CHECK(right.side == 1);
  CHECK(right.along == Approx(0.5));
  CHECK(right.point == Vec2{1.0, 0.5});
  CHECK(square.sides[0].nearest({7.0, 1.0}).point == Vec2{1.0, 0.0});

  const Outline disc = outline_of(Disc{2.0});
  const OutlinePoint left = nearest_on(disc, {-0.5, 1.0});
  CHECK(left.side == 1);
  CHECK(left.point.x == Approx(-1.0));
  CHECK(left.along == Approx(0.5 * std::numbers::pi));
  // Beyond the right half circle's end: its nearest point is that end.
  CHECK(disc.sides[0].nearest({-0.1, 2.0}).point == Vec2{0.0, 2.0});
  CHECK(disc.sides[0].nearest({-0.1, 0.0}).point == Vec2{0.0, 0.0});
}

TEST_CASE("the experiment chooses the outline") {
  ExperimentConfig experiment;
  CHECK(outline_of(experiment).sides.size() == 2);
  experiment.type = ExperimentType::triaxial;
  CHECK(outline_of(experiment).sides.size() == 4);
}

TEST_CASE("a point inside a polygon that is not convex") {
  const std::vector<Vec2> arrow{{0, 0}, {2, 1}, {0, 2}, {1, 1}};
  CHECK(contains(arrow, {1.5, 1.0}));
  CHECK_FALSE(contains(arrow, {0.5, 1.0}));
  CHECK_FALSE(contains(arrow, {3.0, 1.0}));
}

TEST_CASE("darts keep their distance and stay inside") {
  const std::vector<Vec2> square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  PointSet set;
  set.points.push_back({{5.0, 5.0}, Freedom::fixed});
  RandomStream random(1, "test");
  throw_darts(set, square, 60, 1.0, random);
  REQUIRE(set.points.size() == 61);
  for (std::size_t i = 1; i < set.points.size(); ++i) {
    CHECK(contains(square, set.points[i].at));
    for (std::size_t j = 0; j < i; ++j) CHECK(norm(set.points[i].at - set.points[j].at) >= 1.0);
  }
  throw_darts(set, square, 10000, 1.0, random);
  CHECK(set.points.size() < 128);  // No more fit: discs of diameter 1 cover at most 0.55 of the area when thrown.
}
