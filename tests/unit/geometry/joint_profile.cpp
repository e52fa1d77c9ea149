#include "core/geometry/joint_profile.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/unit/geometry/joint_configs.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

void check_tooth(const ToothSpan& tooth, const ToothSpan& wanted) {
  CHECK(tooth.begin_mm == Approx(wanted.begin_mm));
  CHECK(tooth.crest_mm == Approx(wanted.crest_mm));
  CHECK(tooth.end_mm == Approx(wanted.end_mm));
  CHECK(tooth.height_mm == Approx(wanted.height_mm));
  CHECK(tooth.front_angle_deg == Approx(wanted.front_angle_deg));
  CHECK(tooth.back_angle_deg == Approx(wanted.back_angle_deg));
}

JointConfig through(std::vector<Vec2> points) {
  JointConfig joint;
  joint.profile.clear();
  joint.points_mm = std::move(points);
  return joint;
}

}  // namespace

TEST_CASE("the single tooth of 30 degrees is 24.32 mm long") {
  const JointProfile profile = joint_profile(single_tooth());
  REQUIRE(profile.points.size() == 5);
  CHECK(profile.points.front() == Vec2{0.0, 0.0});
  CHECK(profile.points[2].y == 5.0);
  CHECK(profile.length() == Approx(24.3205).epsilon(1e-6));  // 7 + 10 / tan 30
  CHECK(profile.lowest() == 0.0);
  CHECK(profile.highest() == 5.0);
  REQUIRE(profile.teeth.size() == 1);
  check_tooth(profile.teeth[0], {3.5, 12.160254, 20.820508, 5.0, 30.0, 30.0});
}

TEST_CASE("the double tooth of 15 and 30 degrees is 61.64 mm long") {
  const JointProfile profile = joint_profile(double_tooth());
  CHECK(profile.points.size() == 7);  // No flat between the teeth.
  CHECK(profile.length() == Approx(61.6410).epsilon(1e-6));
  REQUIRE(profile.teeth.size() == 2);
  check_tooth(profile.teeth[0], {3.5, 22.160254, 40.820508, 5.0, 15.0, 15.0});
  check_tooth(profile.teeth[1], {40.820508, 49.480762, 58.141016, 5.0, 30.0, 30.0});
}

TEST_CASE("a joint of gaps alone is flat, one of teeth alone has no flats") {
  JointConfig joint;
  joint.profile.clear();
  joint.end_gap_mm = 30.0;
  const JointProfile flat = joint_profile(joint);
  CHECK(flat.points == std::vector<Vec2>{{0, 0}, {30, 0}});
  CHECK(flat.teeth.empty());
  joint.profile = {{45.0, 2.0, 0.0}};
  joint.end_gap_mm = 0.0;
  CHECK(joint_profile(joint).points.size() == 3);
}

TEST_CASE("the height between points is that of the straight line") {
  const JointProfile profile = joint_profile(through({{0, 1}, {2, 3}, {6, -1}}));
  CHECK(profile.height_at(0.0) == 1.0);
  CHECK(profile.height_at(0.5) == 1.5);
  CHECK(profile.height_at(2.0) == 3.0);
  CHECK(profile.height_at(5.0) == 0.0);
  CHECK(profile.height_at(6.0) == -1.0);
  CHECK(profile.lowest() == -1.0);
  CHECK(profile.highest() == 3.0);
}

TEST_CASE("points begin at x = 0 and those on a straight line are merged") {
  const JointProfile profile = joint_profile(through({{10, 0}, {11, 0.1}, {12, 0.2}, {13, 0.3}, {14, 0}, {15, 0}}));
  REQUIRE(profile.points.size() == 4);
  CHECK(profile.points[0] == Vec2{0, 0});
  CHECK(profile.points[1] == Vec2{3, 0.3});
  CHECK(profile.points[3] == Vec2{5, 0});
}

TEST_CASE("teeth of a rough profile lie above the plane, between minima") {
  // A tooth that rises from below the plane, a minimum above it, a flat crest, a ledge, a flat foot, and a valley.
  const JointProfile profile = joint_profile(
      through({{0, -1}, {2, 1}, {3, 0.5}, {4, 2}, {6, 2}, {7, 1}, {8, 1}, {10, -1}, {12, -1}, {13, -0.5}, {14, -1}}));
  REQUIRE(profile.teeth.size() == 2);
  check_tooth(profile.teeth[0], {1.0, 2.0, 3.0, 1.0, 45.0, std::atan(0.5) * 180.0 / 3.14159265358979});
  check_tooth(profile.teeth[1], {3.0, 5.0, 9.0, 2.0, std::atan(0.75) * 180.0 / 3.14159265358979,
                                 std::atan(0.5) * 180.0 / 3.14159265358979});
}

TEST_CASE("a profile that begins or ends on a flank has half a tooth there") {
  const JointProfile profile = joint_profile(through({{0, 2}, {2, 0}, {4, 0}, {6, 2}}));
  REQUIRE(profile.teeth.size() == 2);
  check_tooth(profile.teeth[0], {0.0, 0.0, 2.0, 2.0, 0.0, 45.0});
  check_tooth(profile.teeth[1], {4.0, 6.0, 6.0, 2.0, 45.0, 0.0});
  CHECK(joint_profile(through({{0, 1}, {5, 1}})).teeth.empty());
}
