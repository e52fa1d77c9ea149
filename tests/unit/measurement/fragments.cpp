#include "core/measurement/fragments.hpp"

#include <catch2/catch.hpp>

#include "tests/support/models.hpp"
#include "tests/unit/measurement/small_specimen.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

void cut(SmallSpecimen& s, int t, int u) {
  break_contact(s.contacts, contact_between(s.contacts, t, u), BreakMode::tension, 1.0);
}

Fragments fragments(const SmallSpecimen& s) { return find_fragments(s.contacts, s.particles); }

}  // namespace

TEST_CASE("an intact specimen is one fragment") {
  const Fragments f = fragments(small_specimen(3, 1));
  CHECK(f.of_triangle == std::vector<int>(6, 0));
  CHECK(f.area_mm2 == std::vector<double>{3.0});
}

TEST_CASE("a cut through a strip makes two fragments, the larger one first") {
  SmallSpecimen s = small_specimen(3, 1);
  cut(s, 0, 3);  // between the first square and the second
  CHECK(fragments(s).of_triangle == std::vector<int>{1, 1, 0, 0, 0, 0});
  CHECK(fragments(s).area_mm2 == std::vector<double>{2.0, 1.0});
}

TEST_CASE("a crack that one can go round cuts nothing off") {
  SmallSpecimen s = small_specimen(2, 2);
  cut(s, 0, 3);
  CHECK(fragments(s).area_mm2.size() == 1);
  cut(s, 4, 7);
  CHECK(fragments(s).area_mm2 == std::vector<double>{2.0, 2.0});
}

TEST_CASE("of equal fragments the one with the first triangle comes first") {
  SmallSpecimen s = small_specimen(2, 1);
  cut(s, 0, 3);
  CHECK(fragments(s).of_triangle == std::vector<int>{0, 0, 1, 1});
}

TEST_CASE("a softening contact still holds") {
  SmallSpecimen s = small_specimen(2, 1);
  test::change_points(s.contacts, contact_between(s.contacts, 0, 3), [](PointState& point) { point.damage = 0.99; });
  CHECK(fragments(s).area_mm2.size() == 1);
}

TEST_CASE("every triangle on its own when all contacts are broken") {
  SmallSpecimen s = small_specimen(2, 1);
  for (int c = 0; c < static_cast<int>(s.contacts.size()); ++c) break_contact(s.contacts, c, BreakMode::shear, 1.0);
  CHECK(fragments(s).of_triangle == std::vector<int>{0, 1, 2, 3});
}

TEST_CASE("the triangles of a grain stay together without contacts between them") {
  Mesh mesh = grid_mesh(2, 1, 1.0);
  mesh.grain = {0, 0, 1, 1};
  SmallSpecimen s = specimen_of(mesh);
  REQUIRE(s.contacts.size() == 1);
  break_contact(s.contacts, 0, BreakMode::tension, 1.0);
  CHECK(fragments(s).of_triangle == std::vector<int>{0, 0, 1, 1});
}
