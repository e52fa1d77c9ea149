#include "core/geometry/joint_strips.hpp"

#include <catch2/catch.hpp>
#include <cstring>
#include <set>

using namespace asperity;

namespace {

JointConfig tooth() {
  JointConfig joint;
  joint.profile = {{45.0, 2.0, 3.0}};
  joint.end_gap_mm = 3.0;
  joint.lower_height_mm = joint.upper_height_mm = 8.0;
  joint.coarse_edge_mm = 2.0;
  return joint;
}

ParticleConfig particles(std::uint64_t seed = 4) {
  ParticleConfig p;
  p.edge_mm = 1.0;
  p.seed = seed;
  return p;
}

bool is_upper(JointZone zone) { return zone == JointZone::upper_particles || zone == JointZone::upper_elastic; }

bool same_bytes(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec2)) == 0;
}

}  // namespace

TEST_CASE("the lift of halves that do not mate is the most by which the faces would overlap") {
  const JointProfile p = joint_profile(tooth());  // 45 degrees: from 3 up to (5, 2) and down to 7, length 10
  CHECK(mismatch_lift(p, 0.0) == 0.0);
  CHECK(mismatch_lift(p, 0.5) == Approx(0.5).epsilon(1e-12));  // on the flank
  CHECK(mismatch_lift(p, 1.75) == Approx(1.75).epsilon(1e-12));
  CHECK(mismatch_lift(p, 3.0) == Approx(2.0).epsilon(1e-12));  // crest against the flat part
  JointConfig two = tooth();  // feet from 2 to 4 and from 5 to 9: the steeper tooth counts
  two.profile = {{20.0, 0.5, 2.0}, {60.0, 1.0, 2.0}};
  CHECK(mismatch_lift(joint_profile(two), 0.1) == Approx(0.1 * std::sqrt(3.0)).epsilon(1e-9));
  JointConfig falling = tooth();
  falling.profile = JointConfig().profile;
  falling.points_mm = {{0.0, 0.0}, {10.0, -4.0}};
  CHECK(mismatch_lift(joint_profile(falling), 1.0) == Approx(-0.4).epsilon(1e-12));  // shifting opens it
}

TEST_CASE("one strip that fits is the joint's mesh to the byte") {
  const JointMesh base = make_joint_mesh(tooth(), particles());
  const JointAssembly made = make_joint_strips(tooth(), particles(), 1, 0.0);
  CHECK(same_bytes(made.joint.mesh.vertices, base.mesh.vertices));
  CHECK(made.joint.mesh.triangles == base.mesh.triangles);
  CHECK(made.joint.mesh.grain == base.mesh.grain);
  CHECK(made.joint.zone == base.zone);
  CHECK(made.strips.count == 1);
  CHECK(made.strips.of(5) == 0);
}

TEST_CASE("a mismatch moves the upper half alone, and leaves the faces in touch without overlap") {
  const JointMesh base = make_joint_mesh(tooth(), particles());
  const JointAssembly made = make_joint_strips(tooth(), particles(), 1, 0.5);
  CHECK(made.strips.upper_shift.x == 0.5);
  double least = 1e9;
  for (std::size_t t = 0; t < base.zone.size(); ++t) {
    for (int v : base.mesh.triangles[t]) {
      const Vec2 moved = made.joint.mesh.vertices[v] - base.mesh.vertices[v];
      CHECK(norm(moved - (is_upper(base.zone[t]) ? made.strips.upper_shift : Vec2{})) < 1e-14);
      const Vec2 at = made.joint.mesh.vertices[v];
      if (is_upper(base.zone[t]) && at.x <= 10.0) least = std::min(least, at.y - made.joint.profile.height_at(at.x));
    }
  }
  CHECK(least == Approx(0.0).margin(1e-12));
}

TEST_CASE("strips have their own seeds, share nothing and lie clear of each other") {
  const JointAssembly made = make_joint_strips(tooth(), particles(4), 3, 0.5);
  CHECK(made.strips.count == 3);
  std::size_t triangle = 0;
  std::vector<std::set<int>> vertices(3), grains(3);
  for (int strip = 0; strip < 3; ++strip) {
    const JointMesh own = make_joint_strips(tooth(), particles(4 + strip * kStripSeeds), 1, 0.5).joint;
    for (std::size_t t = 0; t < own.zone.size(); ++t, ++triangle) {
      REQUIRE(made.strips.of(triangle) == strip);
      CHECK(made.joint.zone[triangle] == own.zone[t]);
      grains[strip].insert(made.joint.mesh.grain[triangle]);
      for (int k = 0; k < 3; ++k) {
        const int v = made.joint.mesh.triangles[triangle][k];
        vertices[strip].insert(v);
        const Vec2 expected = own.mesh.vertices[own.mesh.triangles[t][k]] + Vec2{0.0, strip * made.strips.pitch_mm};
        CHECK(made.joint.mesh.vertices[v] == expected);
      }
    }
  }
  CHECK(triangle == made.joint.zone.size());
  for (const auto* sets : {&vertices, &grains}) {
    CHECK((*sets)[0].size() + (*sets)[1].size() + (*sets)[2].size() == [&] {
      std::set<int> all;
      for (const auto& s : *sets) all.insert(s.begin(), s.end());
      return all.size();
    }());
  }
  CHECK(made.strips.pitch_mm > 8.0 + 8.0 + 0.5 + 2.0 * (2.0 + 0.5));  // heights, lift and twice the dilation
}
