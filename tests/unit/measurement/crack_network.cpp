#include "core/measurement/crack_network.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/models.hpp"
#include "tests/unit/measurement/small_specimen.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

/// Two squares of 2 mm side by side: contacts are two diagonals and the upright edge between them.
struct TwoSquares {
  SmallSpecimen s = small_specimen(2, 1, 2.0);
  int left_diagonal = contact_between(s.contacts, 0, 1);
  int upright = contact_between(s.contacts, 0, 3);
  int right_diagonal = contact_between(s.contacts, 2, 3);
  std::vector<Crack> cracks() const { return list_cracks(s.contacts, s.particles); }
};

CrackCounts counts(const SmallSpecimen& s) { return count_cracks(s.contacts, ParallelLoops()); }

}  // namespace

TEST_CASE("an intact specimen has no cracks") {
  const TwoSquares t;
  CHECK(t.s.contacts.size() == 3);
  CHECK(t.cracks().empty());
  CHECK(crack_segments(t.s.contacts, t.s.particles).empty());
  CHECK(counts(t.s).tension + counts(t.s).shear + counts(t.s).softening == 0);
}

TEST_CASE("a crack has the place, direction and length of its undeformed edge") {
  TwoSquares t;
  break_contact(t.s.contacts, t.upright, BreakMode::tension, 1.0);
  break_contact(t.s.contacts, t.left_diagonal, BreakMode::shear, 2.0);
  for (Vec2& x : t.s.particles.position) x += {5.0, -3.0};
  const std::vector<Crack> cracks = t.cracks();
  REQUIRE(cracks.size() == 2);
  // Hand numbers; atan2 of exact grid points and a square root are good to a few units in the last place.
  CHECK(cracks[0].orientation_deg == Approx(90).epsilon(1e-15));
  CHECK(norm(cracks[0].place - Vec2{0, 1}) == 0.0);
  CHECK(cracks[0].length_mm == 2.0);
  CHECK(cracks[0].mode == BreakMode::tension);
  CHECK(cracks[1].orientation_deg == Approx(45).epsilon(1e-15));
  CHECK(norm(cracks[1].place - Vec2{-1, 1}) == 0.0);
  CHECK(cracks[1].length_mm == Approx(2 * std::sqrt(2.0)).epsilon(1e-15));
  CHECK(cracks[1].mode == BreakMode::shear);
}

TEST_CASE("directions lie from 0 to below 180 degrees whichever way the edge runs") {
  SmallSpecimen s = small_specimen(1, 2, 2.0);
  const int level = contact_between(s.contacts, 1, 2);
  break_contact(s.contacts, level, BreakMode::tension, 1.0);
  CHECK(list_cracks(s.contacts, s.particles)[0].orientation_deg == 0.0);
  ContactEdge& e = s.contacts.edges[level];
  std::swap(e.left1, e.left2);
  std::swap(e.right1, e.right2);
  CHECK(list_cracks(s.contacts, s.particles)[0].orientation_deg == 0.0);
}

TEST_CASE("cracks come in the order of time and then of contact") {
  TwoSquares t;
  break_contact(t.s.contacts, 0, BreakMode::tension, 3.0);
  break_contact(t.s.contacts, 1, BreakMode::tension, 1.0);
  break_contact(t.s.contacts, 2, BreakMode::tension, 1.0);
  const std::vector<Crack> cracks = t.cracks();
  REQUIRE(cracks.size() == 3);
  CHECK(std::vector<int>{cracks[0].contact, cracks[1].contact, cracks[2].contact} == std::vector<int>{1, 2, 0});
}

TEST_CASE("a crack's energy is that of its two halves and its mode that of the half that spent more") {
  TwoSquares t;
  break_contact(t.s.contacts, t.upright, BreakMode::tension, 1.0);
  auto points = t.s.contacts.points(t.upright);
  points[0].fracture_energy = 0.25;
  points[1].fracture_energy = 0.5;
  points[1].broken = BreakMode::shear;
  t.s.contacts.set_points(t.upright, points);
  const Crack crack = t.cracks().at(0);
  CHECK(crack.energy_n_mm == 0.75);  // (0.25 + 0.5) N/mm on 1 mm each
  CHECK(crack.mode == BreakMode::shear);
}

TEST_CASE("an edge with one broken point only softens") {
  TwoSquares t;
  auto points = t.s.contacts.points(t.upright);
  points[0].broken = BreakMode::tension;
  points[0].damage = 1.0;
  t.s.contacts.set_points(t.upright, points);
  CHECK(t.cracks().empty());
  CHECK(counts(t.s).softening == 1);
  CHECK(counts(t.s).tension == 0);
  const std::vector<CrackSegment> segments = crack_segments(t.s.contacts, t.s.particles);
  REQUIRE(segments.size() == 1);
  CHECK(segments[0].mode == CrackMode::softening);
  CHECK(segments[0].damage == 0.5);
  CHECK(segments[0].break_time_s < 0.0);
}

TEST_CASE("counts tell the modes apart") {
  TwoSquares t;
  break_contact(t.s.contacts, 0, BreakMode::tension, 1.0);
  break_contact(t.s.contacts, 1, BreakMode::shear, 1.0);
  test::change_points(t.s.contacts, 2, [](PointState& point) { point.damage = 0.1; });
  CHECK(counts(t.s).tension == 1);
  CHECK(counts(t.s).shear == 1);
  CHECK(counts(t.s).softening == 1);
}

TEST_CASE("a drawn crack lies midway between its two particles as they are now") {
  TwoSquares t;
  break_contact(t.s.contacts, t.upright, BreakMode::tension, 1.5, 0.125);
  for (int triangle : {2, 3}) {
    for (int node : t.s.particles.triangles[triangle]) t.s.particles.position[node] += {0.5, 0.25};
  }
  const CrackSegment segment = crack_segments(t.s.contacts, t.s.particles).at(0);
  CHECK(0.5 * (segment.a + segment.b) == Vec2{0.25, 1.125});
  CHECK(norm(segment.b - segment.a) == 2.0);
  CHECK(segment.opening_mm == 0.5);
  CHECK(segment.slip_mm == 0.25);
  CHECK(segment.break_time_s == 1.5);
  CHECK(segment.energy_n_mm == 0.25);
}
