#include "core/measurement/contact_forces.hpp"

#include <catch2/catch.hpp>

#include "core/measurement/capture.hpp"
#include "tests/support/models.hpp"
#include "tests/unit/measurement/small_specimen.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

constexpr double kThickness = 10.0;  // mm

/// Two squares of 2 mm side by side: contacts are two diagonals and the upright edge between them.
struct TwoSquares {
  SmallSpecimen s = small_specimen(2, 1, 2.0);
  int left_diagonal = contact_between(s.contacts, 0, 1);
  int upright = contact_between(s.contacts, 0, 3);

  /// Tractions of the two points of a contact, MPa, tension positive.
  void load(int contact, std::array<double, 2> normal, std::array<double, 2> shear) {
    std::array<PointState, 2> points = s.contacts.points(contact);
    for (std::size_t i = 0; i < 2; ++i) {
      points[i].traction_n = normal[i];
      points[i].traction_s = shear[i];
    }
    s.contacts.set_points(contact, points);
  }

  std::vector<ContactForce> forces() const { return bonded_contact_forces(s.contacts, s.particles, kThickness); }
};

}  // namespace

TEST_CASE("an unloaded specimen has no contact forces") { CHECK(TwoSquares().forces().empty()); }

TEST_CASE("a contact's force is its tractions over the edge's length and the thickness, compression positive") {
  TwoSquares t;
  t.load(t.upright, {-3.0, -1.0}, {0.5, -2.0});
  const std::vector<ContactForce> forces = t.forces();
  REQUIRE(forces.size() == 1);
  // Each point stands for 1 mm of the edge and 10 mm of thickness: 30 N and 10 N; |5 N - 20 N|.
  CHECK(forces[0].normal_n == 40.0);
  CHECK(forces[0].shear_n == 15.0);
  CHECK(forces[0].kind == ContactKind::bonded);
}

TEST_CASE("tension is negative") {
  TwoSquares t;
  t.load(t.upright, {2.0, 2.0}, {0.0, 0.0});
  CHECK(t.forces().at(0).normal_n == -40.0);
}

TEST_CASE("a force runs between the centroids of its particles and through the middle of their edge, as they are now") {
  TwoSquares t;
  t.load(t.upright, {-1.0, -1.0}, {0.0, 0.0});
  for (int triangle : {2, 3}) {
    for (int node : t.s.particles.triangles[triangle]) t.s.particles.position[node] += {0.5, 0.25};
  }
  const ContactForce force = t.forces().at(0);
  // Triangle 0 has corners (-2, 0), (0, 0), (0, 2); triangle 3 had (0, 0), (2, 2), (0, 2).
  const Vec2 centre0{-2.0 / 3, 2.0 / 3}, centre3{2.0 / 3 + 0.5, 4.0 / 3 + 0.25};
  const Vec2 a = force.a.x < force.b.x ? force.a : force.b, b = force.a.x < force.b.x ? force.b : force.a;
  CHECK(norm(a - centre0) < 1e-15);  // rounding of thirds at 2 mm
  CHECK(norm(b - centre3) < 1e-15);
  CHECK(force.point == Vec2{0.25, 1.125});
}

TEST_CASE("a broken contact that still carries force says so") {
  TwoSquares t;
  break_contact(t.s.contacts, t.upright, BreakMode::shear, 1.0);
  t.load(t.upright, {-1.0, -1.0}, {0.25, 0.25});
  t.load(t.left_diagonal, {-1.0, -1.0}, {0.0, 0.0});
  int broken = 0;
  for (const ContactForce& force : t.forces()) {
    if (force.kind != ContactKind::broken) continue;
    ++broken;
    CHECK(force.normal_n == 20.0);
    CHECK(force.shear_n == 5.0);
  }
  CHECK(broken == 1);
  CHECK(t.forces().size() == 2);
}

TEST_CASE("forces below a milliardth of the largest are left out") {
  TwoSquares t;
  t.load(t.upright, {-1.0, -1.0}, {0.0, 0.0});
  t.load(t.left_diagonal, {-1e-10, -1e-10}, {0.0, 0.0});
  CHECK(t.forces().size() == 1);
  t.load(t.left_diagonal, {-1e-10, -1e-10}, {1e-8, 1e-8});  // the diagonal is longer still
  CHECK(t.forces().size() == 2);
}

TEST_CASE("the edges that two grains share are one contact, bonded until the last is broken") {
  Mesh mesh = grid_mesh(2, 2, 1.0);
  mesh.grain = {0, 0, 1, 1, 0, 0, 1, 1};  // the left and the right column: two edges of 1 mm between them
  SmallSpecimen s = specimen_of(mesh);
  REQUIRE(s.contacts.size() == 2);
  test::change_points(s.contacts, 0, [](PointState& point) { point.traction_n = -1.0, point.traction_s = 0.5; });
  test::change_points(s.contacts, 1, [](PointState& point) { point.traction_n = -3.0, point.traction_s = -2.0; });
  break_contact(s.contacts, 0, BreakMode::shear, 1.0);
  const std::vector<ContactForce> forces = bonded_contact_forces(s.contacts, s.particles, kThickness);
  REQUIRE(forces.size() == 1);
  CHECK(forces[0].normal_n == 40.0);
  CHECK(forces[0].shear_n == 15.0);  // 5 N one way, 20 N the other
  CHECK(forces[0].kind == ContactKind::bonded);
  CHECK(forces[0].point == Vec2{0, 1});
  CHECK(norm(forces[0].a - forces[0].b) == Approx(1.0).epsilon(1e-15));
  break_contact(s.contacts, 1, BreakMode::shear, 1.0);
  CHECK(bonded_contact_forces(s.contacts, s.particles, kThickness).at(0).kind == ContactKind::broken);
}

TEST_CASE("a particle's centroid weighs its triangles by their area") {
  Mesh mesh = grid_mesh(2, 1, 1.0);
  mesh.grain = {0, 0, 0, 1};
  const std::vector<Vec2> centre = particle_centres(specimen_of(mesh).particles);
  REQUIRE(centre.size() == 2);
  // Square (-0.5, 0.5) of area 1 and triangle (2/3, 1/3) of area 1/2.
  CHECK(norm(centre[0] - Vec2{(-0.5 + 0.5 * 2 / 3) / 1.5, (0.5 + 0.5 / 3) / 1.5}) < 1e-15);
  CHECK(norm(centre[1] - Vec2{1.0 / 3, 2.0 / 3}) < 1e-15);
}

TEST_CASE("a frame has the contact forces of the whole thickness") {
  TwoSquares t;
  t.load(t.upright, {-1.0, -1.0}, {0.0, 0.0});
  System system;
  system.particles = t.s.particles;
  system.contacts = t.s.contacts;
  RunConfig config;
  config.experiment.thickness_mm = kThickness;
  const Frame frame = capture_frame(system, config, {}, 0);
  REQUIRE(frame.contacts.size() == 1);
  CHECK(frame.contacts[0].normal_n == 20.0);
}
