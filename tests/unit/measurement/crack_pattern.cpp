#include "core/measurement/crack_pattern.hpp"

#include <catch2/catch.hpp>

#include "tests/unit/measurement/patterns.hpp"
#include "tests/unit/measurement/small_specimen.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

constexpr BreakMode kTension = BreakMode::tension, kShear = BreakMode::shear;

CrackPattern one_line(Vec2 to) { return chain({{0, 0}, to}, kTension); }

auto above(double y) {
  return [y](Vec2 place) { return place.y > y; };
}
auto below(double y) {
  return [y](Vec2 place) { return place.y < y; };
}

}  // namespace

TEST_CASE("a crack's angle is from the loading axis, positive to the right, whichever end comes first") {
  CHECK(axial_statistics(one_line({0, 1})).mean_deg == Approx(0.0).margin(1e-12));
  CHECK(axial_statistics(one_line({1, 1})).mean_deg == Approx(45.0));
  CHECK(axial_statistics(one_line({-1, -1})).mean_deg == Approx(45.0));
  CHECK(axial_statistics(one_line({-1, 1})).mean_deg == Approx(-45.0));
  CHECK(axial_statistics(one_line({1, 0})).mean_deg == Approx(90.0));
  CHECK(axial_statistics(one_line({-1, 0})).mean_deg == Approx(90.0));
  CHECK(principal_direction(one_line({-1, 1})).angle_deg == Approx(-45.0));
  CHECK(principal_direction(one_line({3, 0})).angle_deg == Approx(90.0));
}

TEST_CASE("cracks across the sign of their angle average along the load, not across it") {
  const CrackPattern near_axis = chain({{0, 0}, {0.1, 1}, {0, 2}}, kTension);  // +5.7 and -5.7 degrees
  const AxialStatistics s = axial_statistics(near_axis);
  CHECK(s.mean_deg == Approx(0.0).margin(1e-12));
  CHECK(s.order_parameter == Approx(std::cos(2 * std::atan(0.1))));
  CHECK(s.mean_deviation_deg == Approx(std::atan(0.1) * 180 / std::numbers::pi));
  const CrackPattern across = chain({{0, 0}, {1, 0.1}, {2, 0}}, kTension);
  CHECK(std::abs(axial_statistics(across).mean_deg) == Approx(90.0));
  CHECK(axial_statistics(across).order_parameter < -0.97);
}

TEST_CASE("orientation is weighted by length") {
  const CrackPattern cracks = chain({{0, 0}, {0, 3}, {1, 3}}, kTension);  // three along, one across
  const AxialStatistics s = axial_statistics(cracks);
  CHECK(s.order_parameter == Approx((3.0 - 1.0) / 4.0));
  CHECK(s.resultant == Approx(0.5));
  CHECK(s.mean_deviation_deg == Approx(90.0 / 4.0));
}

TEST_CASE("a zigzag of equilateral edges has half the order, and its own direction by second moments") {
  const double sway = 0.25, piece = sway * std::sqrt(3.0) * 2;  // edges at 30 degrees
  const CrackPattern split = straight({0, 0}, {0, 40 * piece}, 40, kTension, 0, sway);
  CHECK(axial_statistics(split).order_parameter == Approx(0.5));
  const PrincipalDirection direction = principal_direction(split);
  CHECK(direction.angle_deg == Approx(0.0).margin(0.1));
  CHECK(direction.elongation > 20.0);
}

TEST_CASE("scattered cracks have no direction") {
  const CrackPattern cracks = scattered(4000, 54, 130, 2);
  const AxialStatistics s = axial_statistics(cracks);
  CHECK(s.resultant < 0.05);  // 1/sqrt(4000) = 0.016 is one standard deviation of each component, times sqrt 1/2
  CHECK(s.mean_deviation_deg == Approx(45.0).margin(1.5));
  CHECK(principal_direction(cracks).elongation == Approx(130.0 / 54.0).epsilon(0.05));
}

TEST_CASE("a square cross has no elongation, a straight line an infinite one") {
  const CrackPattern plus = chain({{-1, 0}, {1, 0}}, kTension, 0) + chain({{0, -1}, {0, 1}}, kTension, 10);
  CHECK(principal_direction(plus).elongation == Approx(1.0));
  CHECK(std::isinf(principal_direction(one_line({1, 2})).elongation));
}

TEST_CASE("an empty pattern has no direction, share or cluster") {
  CHECK(std::isnan(axial_statistics({}).mean_deg));
  CHECK(std::isnan(principal_direction({}).angle_deg));
  CHECK(std::isnan(length_share({}, [](const CrackLine&) { return true; })));
  CHECK(largest_cluster({}).empty());
  CHECK(shortest_path({}, below(1), above(2)).empty());
}

TEST_CASE("the largest cluster is the one of most length, joined at shared vertices alone") {
  const CrackPattern two = chain({{0, 0}, {0, 1}, {0, 2}}, kTension), other = chain({{0, 2}, {0, 5}}, kShear, 10);
  const CrackPattern cluster = largest_cluster(two + other);  // they touch in space, but share no vertex
  REQUIRE(cluster.size() == 1);
  CHECK(cluster[0].mode == kShear);
  const CrackPattern joined = largest_cluster(two + chain({{0, 2}, {0, 5}}, kShear, 2));
  CHECK(joined.size() == 3);
}

TEST_CASE("of two ways the shorter is taken, and no way leads over a gap") {
  // Vertices 0 (bottom) and 5 (top), joined straight by 0-1-5, and in a detour of shear cracks 0-2-5.
  const CrackPattern straight_way =
      chain({{0, 0}, {0, 5}}, kTension) + CrackPattern{{{1, 5}, {Vec2{0, 5}, Vec2{0, 10}}, kTension}};
  const CrackPattern detour{{{0, 2}, {Vec2{0, 0}, Vec2{4, 5}}, kShear}, {{2, 5}, {Vec2{4, 5}, Vec2{0, 10}}, kShear}};
  const CrackPattern path = shortest_path(detour + straight_way, below(1), above(9));
  REQUIRE(path.size() == 2);
  CHECK(total_length(path) == Approx(10.0));
  CHECK(length_share(path, [](const CrackLine& c) { return c.mode == kTension; }) == 1.0);
  CHECK(shortest_path(detour, below(1), above(9)).size() == 2);
  CHECK(shortest_path(CrackPattern{detour[0]}, below(1), above(9)).empty());
}

TEST_CASE("a pattern holds the contacts broken up to a time, on the mesh at rest") {
  SmallSpecimen s = small_specimen(2, 1);
  break_contact(s.contacts, contact_between(s.contacts, 0, 3), kShear, 1.0);
  break_contact(s.contacts, contact_between(s.contacts, 0, 1), kTension, 2.0);
  for (Vec2& place : s.particles.position) place += {5.0, 5.0};
  CHECK(crack_pattern(s.contacts, s.particles, 0.9).empty());
  const CrackPattern first = crack_pattern(s.contacts, s.particles, 1.0);
  REQUIRE(first.size() == 1);
  CHECK(first[0].mode == kShear);
  CHECK(first[0].middle() == Vec2{0.0, 0.5});
  CHECK(first[0].length() == 1.0);
  const CrackPattern both = crack_pattern(s.contacts, s.particles, 2.0);
  CHECK(both.size() == 2);
  CHECK(largest_cluster(both).size() == 2);  // they meet at the diagonal's upper end
}
