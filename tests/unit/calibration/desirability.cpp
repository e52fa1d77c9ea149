#include "core/calibration/desirability.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/unit/calibration/examples.hpp"

using namespace asperity;
using examples::Point;

TEST_CASE("desirability falls linearly from the target to the half range, or by its exponent") {
  const Target target = examples::target_of("y", 40.0);
  CHECK(desirability(40.0, target, {0.25, 1.0}) == 1.0);
  CHECK(desirability(45.0, target, {0.25, 1.0}) == Approx(0.5));
  CHECK(desirability(35.0, target, {0.25, 1.0}) == Approx(0.5));
  CHECK(desirability(35.0, target, {0.25, 2.0}) == Approx(0.25));
  CHECK(desirability(50.0, target, {0.25, 1.0}) == 0.0);
  CHECK(desirability(90.0, target, {0.25, 1.0}) == 0.0);
}

TEST_CASE("the overall desirability is the weighted geometric mean") {
  std::vector<Target> targets{examples::target_of("a", 40.0), examples::target_of("b", 8.0)};
  const std::vector<double> values{45.0, 8.5};  // 0.5 and 0.75
  CHECK(overall_desirability(values, targets, {0.25, 1.0}) == Approx(std::sqrt(0.5 * 0.75)));
  targets[1].weight = 3.0;
  CHECK(overall_desirability(values, targets, {0.25, 1.0}) == Approx(std::pow(0.5 * std::pow(0.75, 3.0), 0.25)));
  CHECK(overall_desirability({45.0, 80.0}, targets, {0.25, 1.0}) == 0.0);
}

TEST_CASE("the merit's gradient is its slope, desirable or not") {
  const Design design = examples::plain_design(2);
  const auto system = examples::full_system(
      design,
      {examples::response_of("a", design, [](const Point& x) { return 10.0 + 2.0 * x[0] + x[0] * x[1]; }),
       examples::response_of("b", design, [](const Point& x) { return 5.0 + x[1] - 0.5 * x[0] * x[0]; })},
      {10.5, 5.2});
  for (double half_range : {0.25, 0.02}) {  // at the second the desirability is 0 here
    const DesirabilityOptions options{half_range, 1.5};
    const Point x{0.6, -0.3};
    const bool desirable = merit(system, x, options) > 0.0;
    CHECK(desirable == (half_range > 0.1));
    const auto height = [&](const Point& at) {
      const double m = merit(system, at, options);
      return desirable ? std::log(m) : m;
    };
    const std::vector<double> gradient = merit_gradient(system, x, options);
    for (std::size_t j = 0; j < 2; ++j) {
      Point above = x, below = x;
      above[j] += 1e-6;
      below[j] -= 1e-6;
      // Central differences over 2e-6 of values of order 1 to 100: rounding 1e-14 * 100 / 2e-6.
      CHECK(gradient[j] == Approx((height(above) - height(below)) / 2e-6).epsilon(1e-5));
    }
  }
}
