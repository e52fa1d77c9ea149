#include "core/geometry/moderate.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/error.hpp"
#include "core/geometry/near_boxes.hpp"

using namespace asperity;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("positions after a blow-up are a numerical error") {
  CHECK_NOTHROW(require_moderate(std::vector<Vec2>{{0, 0}, {-1e30, 1e30}}));
  CHECK_NOTHROW(require_moderate({}));
  for (const Vec2 bad : {Vec2{kNan, 0}, Vec2{0, kNan}, Vec2{kInfinity, 0}, Vec2{0, -1e200}}) {
    try {
      require_moderate(std::vector<Vec2>{{1, 1}, bad});
      FAIL("accepted");
    } catch (const Error& error) {
      CHECK(error.kind() == ErrorKind::numerical);
      CHECK_THAT(error.what(), Catch::Contains("not finite"));
    }
  }
}

TEST_CASE("boxes without numbers are not sorted") {
  std::vector<Box> boxes(40, Box{{0, 0}, {1, 1}});
  CHECK(near_boxes(boxes).size() == 40 * 39 / 2);
  for (std::size_t i = 0; i < boxes.size(); i += 2) boxes[i].high.x = kNan;
  CHECK_THROWS_AS(near_boxes(boxes), Error);
}
