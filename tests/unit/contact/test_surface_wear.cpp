#include <catch2/catch.hpp>
#include <cmath>

#include "core/contact/surface_wear.hpp"

using namespace asperity;

namespace {

/// Two members, triangles 4 and 7, that touch by given entries: slots 0-2 are edges of the first, 3-5 of the second.
GeneralContacts two_members() {
  GeneralContacts general;
  const std::array<int, 3> outline{0, 0, 0}, none{-1, -1, -1};
  general.members = {{4, outline, none, none}, {7, {0, -1, 0}, none, none}};
  general.pairs = {{0, 1}};
  general.wear.assign(3 * 8, 0.0);
  return general;
}

void add_touch(GeneralContacts& general, int entry, double length, double wear) {
  Touch touch;
  touch.pair = 0;
  touch.parts[entry].m0 = 1.0;
  touch.friction[entry].length = length;
  touch.friction[entry].wear = wear;
  general.touches.push_back(touch);
}

}  // namespace

TEST_CASE("Eq (C55): friction falls from its first to its residual value with the wear") {
  const SurfaceLaw law{0.7, 1.0, 1.0, {0.6, 0.1, 0.0}};
  CHECK(worn_friction(law, 0.0) == 0.7);
  CHECK(worn_friction(law, 0.1) == Approx(0.7 * (0.6 + 0.4 / std::exp(1.0))));
  CHECK(worn_friction(law, 10.0) == Approx(0.42));
  CHECK(worn_friction({0.7, 1.0, 1.0}, 5.0) == 0.7);
}

TEST_CASE("Eq (C56): slip counts by itself, or in proportion to the stress of both edges together") {
  CHECK(wear_of_slip({0.6, 0.1, 0.0}, 0.03, 5.0, 2.0) == 0.03);
  CHECK(wear_of_slip({0.6, 0.1, 2.0}, 0.03, 5.0, 2.0) == Approx(0.03 * 5.0 / 2.0));  // 2 N / l = 5 MPa over 2 MPa
}

TEST_CASE("Eq (C56): an edge wears by the mean over its entries' lengths, each exposed edge by itself") {
  GeneralContacts general = two_members();
  add_touch(general, 1, 3.0, 0.02);
  add_touch(general, 1, 1.0, 0.06);
  add_touch(general, 5, 2.0, 0.01);
  add_touch(general, 4, 2.0, 0.5);  // edge 1 of the second is bonded
  add_wear(general);
  CHECK(general.wear[3 * 4 + 1] == Approx(0.03));
  CHECK(general.wear[3 * 7 + 2] == 0.01);
  general.touches.resize(1);
  add_wear(general);
  CHECK(general.wear[3 * 4 + 1] == Approx(0.05));
  double others = 0.0;
  for (const double wear : general.wear) others += wear;
  CHECK(others == Approx(0.06));
}

TEST_CASE("wear is kept only where a surface wears") {
  GeneralContactLaw law;
  law.enabled = true;
  CHECK_FALSE(wears(law));
  law.surfaces[1].wear = {1.0, 0.1, 0.0};  // all is left: none
  CHECK_FALSE(wears(law));
  law.surfaces[0].wear = {0.8, 2.0, 1.0};
  CHECK(wears(law));
}
