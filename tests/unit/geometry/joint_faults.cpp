#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "core/base/error.hpp"
#include "core/geometry/joint_mesh.hpp"
#include "core/geometry/joint_profile.hpp"
#include "tests/unit/geometry/joint_configs.hpp"
#include "tests/unit/geometry/mesh_checks.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

using Places = std::vector<std::string>;

Places places(const std::vector<Fault>& faults) {
  Places at;
  for (const Fault& fault : faults) {
    INFO(describe(fault));
    CHECK_FALSE(fault.what.empty());
    CHECK_FALSE(fault.allowed.empty());
    CHECK_FALSE(fault.hint.empty());
    at.push_back(fault.where);
  }
  return at;
}

Places faulty(const JointConfig& joint, double edge_mm = 0.5) {
  return places(joint_faults(joint, particles(ParticleKind::triangle, edge_mm, 1)));
}

template <class Change>
JointConfig changed(JointConfig joint, const Change& change) {
  change(joint);
  return joint;
}

}  // namespace

TEST_CASE("the joints that are meshed here have no faults") {
  for (double edge : {0.5, 1.0})
    for (const JointConfig& joint : {single_tooth(), double_tooth(), rough_joint(), teeth_alone(single_tooth())})
      CHECK(faulty(joint, edge) == Places{});
}

TEST_CASE("every fault of the teeth is found at once, each once") {
  JointConfig joint;
  joint.profile = {{0.0, 5.0, 3.5}, {80.0, 0.0, -1.0}, {-5.0, -1.0, 0.0}};
  joint.end_gap_mm = -2.0;
  const Places wanted{"/joint/profile/0/angle_deg", "/joint/profile/1/angle_deg",
                      "/joint/profile/1/height_mm", "/joint/profile/1/gap_before_mm",
                      "/joint/profile/2/angle_deg", "/joint/profile/2/height_mm",
                      "/joint/end_gap_mm"};
  CHECK(faulty(joint) == wanted);
  try {
    joint_profile(joint);
    FAIL("no error");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::config);
    CHECK(places(error.faults()) == wanted);
  }
  CHECK_THROWS_AS(make_joint_mesh(joint, particles(ParticleKind::triangle, 0.5, 1)), Error);
}

TEST_CASE("a joint of no length") {
  JointConfig joint;
  joint.profile.clear();
  joint.end_gap_mm = 0.0;
  CHECK(faulty(joint) == Places{"/joint/profile"});
}

TEST_CASE("points that run back, stand still or climb too steeply") {
  JointConfig joint = rough_joint();
  joint.points_mm = {{0, 0}, {4, 1}, {3, 2}, {8, 0}, {8, 1}, {8.1, 3}, {20, 0}};
  CHECK(faulty(joint) == Places{"/joint/points_mm/2", "/joint/points_mm/4", "/joint/points_mm/5"});
  joint.points_mm = {{0, 0}};
  CHECK(faulty(joint) == Places{"/joint/points_mm"});
}

TEST_CASE("halves that overlap") {
  const auto lower = [](JointConfig& j) { j.lower_height_mm = 3.9; };
  const auto upper = [](JointConfig& j) { j.upper_height_mm = 8.9; };
  CHECK(faulty(changed(single_tooth(), lower)) == Places{"/joint/lower_height_mm"});
  CHECK(faulty(changed(single_tooth(), upper)) == Places{"/joint/upper_height_mm"});
}

TEST_CASE("a damage zone without room for particles") {
  CHECK(faulty(changed(single_tooth(), [](JointConfig& j) { j.damage_depth_lower_mm = 0.7; })) ==
        Places{"/joint/damage_depth_lower_mm"});
  CHECK(faulty(changed(single_tooth(), [](JointConfig& j) { j.damage_depth_upper_mm = -1.0; })) ==
        Places{"/joint/damage_depth_upper_mm"});
  CHECK(faulty(changed(single_tooth(), [](JointConfig& j) { j.upper_height_mm = 9.5; })) ==
        Places{"/joint/upper_height_mm"});
  CHECK(faulty(changed(single_tooth(), [](JointConfig& j) { j.lower_height_mm = 4.5; })) ==
        Places{"/joint/lower_height_mm"});
  const auto bare = [](JointConfig& j) { j.upper_height_mm = 9.5, j.damage_depth_upper_mm = 0.0; };
  CHECK(faulty(changed(single_tooth(), bare)) == Places{});
}

TEST_CASE("a tooth finer than the edge") {
  JointConfig joint;
  joint.profile = {{30.0, 0.3, 0.7}, {30.0, 5.0, 0.0}};
  joint.end_gap_mm = 0.1;
  CHECK(faulty(joint) == Places{"/joint/profile/0/gap_before_mm", "/joint/profile/0/height_mm", "/joint/end_gap_mm"});
  CHECK(faulty(joint, 0.05) == Places{});
}

TEST_CASE("of a rough profile's many short pieces the shortest is named, merged pieces are not short") {
  JointConfig joint = rough_joint();
  joint.points_mm = {{1, 0}, {1.1, 0.1}, {1.2, 0.2}, {3, 2}, {3.4, 1.5}, {6, 0}, {6.2, 0.1}, {9, 0}};
  const std::vector<Fault> faults = joint_faults(joint, particles(ParticleKind::triangle, 0.5, 1));
  REQUIRE(places(faults) == Places{"/joint/points_mm/6"});
  CHECK(faults[0].what.find("2 such pieces") != std::string::npos);
}

TEST_CASE("teeth alone must not be too sharp or too thin for particles") {
  JointConfig joint = teeth_alone(single_tooth());
  joint.profile = {{9.0, 3.0, 3.5}};
  CHECK(faulty(joint) == Places{"/joint/damage_depth_lower_mm"});
  joint = teeth_alone(rough_joint());
  joint.points_mm = {{0, 0}, {5, 2}, {10, 0.1}, {15, 2}, {20, 0}};
  CHECK(faulty(joint) == Places{"/joint/damage_depth_lower_mm"});
}

TEST_CASE("a coarse edge below the particles' and grains of several triangles") {
  CHECK(faulty(changed(single_tooth(), [](JointConfig& j) { j.coarse_edge_mm = 0.4; })) ==
        Places{"/joint/coarse_edge_mm"});
  CHECK(places(joint_faults(single_tooth(), particles(ParticleKind::voronoi, 0.5, 1))) == Places{"/particles/kind"});
}
