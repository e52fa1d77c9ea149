#include "core/calibration/verification.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/error.hpp"
#include "tests/unit/calibration/examples.hpp"

using namespace asperity;

TEST_CASE("mean, standard deviation and bias, by hand") {
  Target target = examples::target_of("y", 2.0);
  const Verification v = verify(target, {2.0, 2.1, 2.2}, 2.05);
  CHECK(v.mean == Approx(2.1));
  CHECK(v.sd == Approx(0.1));
  CHECK(v.bias == Approx(0.05));
  CHECK(v.predicted.value() == 2.05);
  CHECK(verify(target, {2.0, 2.1, 2.19}, {}).within);
  CHECK_FALSE(verify(target, {2.0, 2.1, 2.21}, {}).within);
  CHECK_FALSE(verify(target, {1.8}, {}).within);
  CHECK(std::isnan(verify(target, {1.8}, {}).sd));
  CHECK_THROWS_WITH(verify(target, {}, {}), Catch::Contains("/verification/y: has no run with a value"));
}
