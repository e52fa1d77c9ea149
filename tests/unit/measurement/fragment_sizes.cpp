#include "core/measurement/fragment_sizes.hpp"

#include <catch2/catch.hpp>
#include <numbers>

using namespace asperity;

TEST_CASE("Sizes of fragments by hand") {
  const double quarter = 0.25 * std::numbers::pi;  // area of a disc of diameter 1
  const std::vector<double> areas{16 * quarter, 1 * quarter, 4 * quarter, 4 * quarter};
  const std::vector<PassingStep> curve = passing_curve(areas);
  REQUIRE(curve.size() == 4);
  CHECK(curve[0].size_mm == Approx(1.0));
  CHECK(curve[0].share == Approx(1.0 / 25.0));
  CHECK(curve[2].size_mm == Approx(2.0));
  CHECK(curve[2].share == Approx(9.0 / 25.0));
  CHECK(curve[3].size_mm == Approx(4.0));
  CHECK(curve[3].share == 1.0);
  CHECK(passing_size(areas, 0.3) == Approx(2.0));
  CHECK(passing_size(areas, 0.5) == Approx(4.0));
  CHECK(passing_size({}, 0.5) == 0.0);
}
