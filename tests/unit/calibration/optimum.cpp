#include "core/calibration/optimum.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/calibration/constrained_ascent.hpp"
#include "tests/unit/calibration/examples.hpp"

using namespace asperity;
using examples::Point;

namespace {

constexpr double kExact = 1e-7;  // the iteration ends when a step is 1e-12; the fit's rounding is 1e-13 of 10

const Design& design(std::size_t k) {
  static const Design two = examples::plain_design(2), three = examples::plain_design(3);
  return k == 2 ? two : three;
}

SearchRegion sphere(std::size_t k) { return {RegionShape::sphere, design(k).alpha}; }

ResponseSystem two_responses(const examples::Function& a, double target_a, const examples::Function& b,
                             double target_b) {
  return examples::full_system(design(2),
                               {examples::response_of("a", design(2), a), examples::response_of("b", design(2), b)},
                               {target_a, target_b});
}

double parabola(const Point& x) { return 10.0 + x[0] * x[0]; }
double slope(const Point& x) { return 10.0 + x[0] + 2.0 * x[1]; }

}  // namespace

TEST_CASE("both of two solutions are found, at their place") {
  // x1^2 = 0.64; x1 + 2 x2 = 0.4: (0.8, -0.2) and (-0.8, 0.6)
  const ResponseSystem system = two_responses(parabola, 10.64, slope, 10.4);
  Optima optima = find_optima(system, sphere(2), {});
  REQUIRE(optima.solutions.size() == 2);
  std::sort(optima.solutions.begin(), optima.solutions.end(),
            [](const Optimum& a, const Optimum& b) { return a.x[0] < b.x[0]; });
  CHECK(optima.solutions[0].x[0] == Approx(-0.8).margin(kExact));
  CHECK(optima.solutions[0].x[1] == Approx(0.6).margin(kExact));
  CHECK(optima.solutions[1].x[0] == Approx(0.8).margin(kExact));
  CHECK(optima.solutions[1].x[1] == Approx(-0.2).margin(kExact));
  for (const Optimum& solution : optima.solutions) {
    CHECK(solution.desirability == Approx(1.0).margin(kExact));
    CHECK(solution.free_directions == 0);
  }
}

TEST_CASE("where one of two solutions lies outside the design, only the other counts") {
  // x1^2 = 1; x1 + 2 x2 = 3.4: (1, 1.2), outside the sphere of radius 1.41, and (-1, 2.2); then 2 x2 + x1 = 1: (1, 0),
  // (-1, 1)
  CHECK(find_optima(two_responses(parabola, 11.0, slope, 10.2), sphere(2), {}).solutions.size() == 2);
  const Optima one = find_optima(two_responses(parabola, 11.0, slope, 11.4), sphere(2), {});
  REQUIRE(one.solutions.size() == 1);
  CHECK(one.solutions[0].x[0] == Approx(1.0).margin(kExact));
}

TEST_CASE("where no solution is, none is told, and the compromise is the best point of the region") {
  // 10 + x1^2 = 14 needs x1 = 2, outside; the largest value on the sphere is 12 at (+-1.41, 0).
  const ResponseSystem system = two_responses(parabola, 14.0, slope, 10.0);
  const Optima optima = find_optima(system, sphere(2), {});
  CHECK(optima.solutions.empty());
  CHECK_FALSE(optima.compromise.within_tolerance);
  CHECK(inside(sphere(2), optima.compromise.x));
  double best = 0.0;  // by looking everywhere, in steps of 0.01
  for (int i = -142; i <= 142; ++i) {
    for (int j = -142; j <= 142; ++j) {
      const Point x{0.01 * i, 0.01 * j};
      if (inside(sphere(2), x)) best = std::max(best, merit(system, x, {}));
    }
  }
  CHECK(optima.compromise.desirability >= best - 1e-9);
  CHECK(optima.compromise.desirability <= best + 0.02);  // what a step of 0.01 can miss of a slope of 2
}

TEST_CASE("the cube reaches further than the sphere, into its corners") {
  // slope at (1.41, 1.41) is 14.24; on the sphere it ends at 10 + 1.41 sqrt(5) = 13.16
  const ResponseSystem system = two_responses(
      slope, 14.0, [](const Point& x) { return 10.0 + x[1]; }, 11.35);
  CHECK(find_optima(system, sphere(2), {}).solutions.empty());
  const Optima optima = find_optima(system, {RegionShape::cube, design(2).alpha}, {});
  CHECK(optima.solutions.size() == 1);
}

TEST_CASE("a climb on the cube stays inside it") {
  const ResponseSystem system = two_responses(slope, 20.0, parabola, 20.0);
  const SearchRegion cube{RegionShape::cube, design(2).alpha};
  const Point top = climb(system, cube, {0.1, 0.1}, {});
  CHECK(inside(cube, top));
  CHECK(top[0] == Approx(design(2).alpha).margin(1e-4));  // the corner, to COBYLA's last step and some
  CHECK(top[1] == Approx(design(2).alpha).margin(1e-4));
}

TEST_CASE("fewer responses than factors: one solution stands for the curve, and says so") {
  const auto ring = [](const Point& x) { return 10.0 + x[0] * x[0] + x[1] * x[1] + 2.0 * x[0]; };
  const ResponseSystem system =
      examples::full_system(design(2), {examples::response_of("a", design(2), ring)}, {10.44});
  // (x1 + 1)^2 + x2^2 = 1.44: the point nearest to the centre is (0.2, 0)
  const Optima optima = find_optima(system, sphere(2), {});
  REQUIRE(optima.solutions.size() == 1);
  CHECK(optima.solutions[0].free_directions == 1);
  CHECK(optima.solutions[0].x[0] == Approx(0.2).margin(1e-3));  // the walk ends when a step gains less than 1e-8 of |x|
  CHECK(optima.solutions[0].x[1] == Approx(0.0).margin(1e-3));
}

TEST_CASE("a factor that no model holds is a free direction") {
  const auto a = [](const Point& x) { return 10.0 + x[0]; };
  const auto b = [](const Point& x) { return 5.0 + x[1]; };
  const ResponseSystem system = examples::full_system(
      design(3), {examples::response_of("a", design(3), a), examples::response_of("b", design(3), b)}, {10.3, 5.4});
  const Optima optima = find_optima(system, sphere(3), {});
  REQUIRE(optima.solutions.size() == 1);
  CHECK(optima.solutions[0].free_directions == 1);
  CHECK(optima.solutions[0].x[0] == Approx(0.3).margin(1e-6));
  CHECK(optima.solutions[0].x[2] == Approx(0.0).margin(1e-6));
}

TEST_CASE("more responses than factors: within tolerance is a solution, beyond it is none") {
  const auto third = [](const Point& x) { return 10.0 + x[0] + x[1]; };
  const auto system = [&](double target) {
    return examples::full_system(design(2),
                                 {examples::response_of("a", design(2), slope),
                                  examples::response_of("b", design(2), [](const Point& x) { return 10.0 + x[0]; }),
                                  examples::response_of("c", design(2), third)},
                                 {10.4, 10.0, target});
  };
  // x1 = 0, x2 = 0.2 meet a and b; c is then 10.2.
  CHECK(find_optima(system(10.3), sphere(2), {}).solutions.size() == 1);
  CHECK(find_optima(system(13.0), sphere(2), {}).solutions.empty());
}
