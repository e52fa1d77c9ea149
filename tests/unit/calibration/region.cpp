#include "core/calibration/region.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/calibration/optimum.hpp"
#include "tests/unit/calibration/examples.hpp"

using namespace asperity;
using examples::Point;

namespace {

double first(const Point& x) { return 10.0 + x[0]; }
double second(const Point& x) { return 20.0 + 2.0 * x[0] + 4.0 * x[1]; }

/// Two linear responses with scatter, and targets at x = (0, 0).
ResponseSystem linear_system(std::uint64_t seed = 1) {
  const Design design = examples::plain_design(2);
  std::vector<ResponseModel> models;
  std::vector<Target> targets{examples::target_of("a", 10.0), examples::target_of("b", 20.0)};
  models.push_back(fit_response(design, examples::response_of("a", design, first, 0.01, seed), {1.0, Hierarchy::free}));
  models.push_back(
      fit_response(design, examples::response_of("b", design, second, 0.01, seed), {1.0, Hierarchy::free}));
  return {models, targets};
}

}  // namespace

TEST_CASE("the covariance of the parameters is J^-1 S J^-T") {
  const ResponseSystem system = linear_system();
  const Point x = least_misses(system, {0.0, 0.0});
  const ConfidenceRegion region = confidence_region(system, x, 0.95, 1.4);
  const std::vector<double> s = system.covariance(x), j = system.jacobian(x);
  const double det = j[0] * j[3] - j[1] * j[2];
  const double inverse[4] = {j[3] / det, -j[1] / det, -j[2] / det, j[0] / det};
  for (std::size_t a = 0; a < 2; ++a) {
    for (std::size_t b = 0; b < 2; ++b) {
      double sum = 0.0;
      for (std::size_t r = 0; r < 2; ++r) {
        for (std::size_t q = 0; q < 2; ++q) sum += inverse[2 * a + r] * s[2 * r + q] * inverse[2 * b + q];
      }
      CHECK(region.covariance[2 * a + b] == Approx(sum).epsilon(1e-6));
    }
  }
  CHECK(region.df == 8);
  // Student's 97.5 % quantile with 8 degrees of freedom is 2.306, its 98.75 % quantile 2.752
  CHECK(region.interval_upper[0] - x[0] == Approx(2.306 * std::sqrt(region.covariance[0])).epsilon(1e-3));
  CHECK(region.upper[0] - x[0] == Approx(2.752 * std::sqrt(region.covariance[0])).epsilon(1e-3));
  CHECK(region.determined[0]);
  CHECK(region.determined[1]);
  CHECK(region.singular_values[0] >= region.singular_values[1]);
}

TEST_CASE("the covariance of predicted means holds the correlation of the responses' scatter") {
  const Design design = examples::plain_design(2);
  Response a = examples::response_of("a", design, first, 0.02, 4);
  Response b = a;
  b.name = "b";
  for (std::size_t i = 0; i < b.values.size(); ++i) b.values[i] = 50.0 - 2.0 * a.values[i];  // same scatter, opposed
  const ModelOptions all{1.0, Hierarchy::free};
  const ResponseSystem system({fit_response(design, a, all), fit_response(design, b, all)},
                              {examples::target_of("a", 10.0), examples::target_of("b", 30.0)});
  const std::vector<double> s = system.covariance({0.3, 0.2});
  CHECK(s[1] == Approx(-2.0 * s[0]));
  CHECK(s[3] == Approx(4.0 * s[0]));
  const Prediction p = predict(system.models()[0], {0.3, 0.2}, 0.95);
  CHECK(std::sqrt(s[0]) == Approx(p.sd_mean));
}

TEST_CASE("the laboratory's own uncertainty widens the region") {
  const ResponseSystem exact = linear_system();
  std::vector<Target> targets = exact.targets();
  targets[0].standard_error = 0.3;
  const ResponseSystem uncertain(exact.models(), targets);
  const Point x = least_misses(exact, {0.0, 0.0});
  const std::vector<double> s = exact.covariance(x), wide = uncertain.covariance(x);
  CHECK(wide[0] == Approx(s[0] + 0.09));
  CHECK(wide[1] == s[1]);
  // The target's 0.3 over the response's slope of about 1 adds to the parameter's scatter.
  const double narrow = confidence_region(exact, x, 0.95, 1.4).covariance[0];
  CHECK(confidence_region(uncertain, x, 0.95, 1.4).covariance[0] == Approx(narrow + 0.09).epsilon(0.1));
}

TEST_CASE("a factor that changes nothing is undetermined, the others stay determined") {
  const Design design = examples::plain_design(3);
  const auto null3 = [](const Point& x) { return 20.0 + 2.0 * x[0] + 4.0 * x[1]; };
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Responses responses;
    responses.list = {examples::response_of("a", design, first, 0.01, seed),
                      examples::response_of("b", design, null3, 0.01, seed)};
    const Analysis analysis =
        analyse(design, responses, {examples::target_of("a", 10.2), examples::target_of("b", 21.0)}, {});
    REQUIRE(analysis.solutions.size() == 1);
    const ConfidenceRegion& region = analysis.solutions[0].region;
    CHECK(region.determined[0]);
    CHECK(region.determined[1]);
    CHECK_FALSE(region.determined[2]);
    CHECK_FALSE(region.direction_determined.back());
    CHECK(std::abs(region.directions.back()[2]) > 0.9);
  }
}

TEST_CASE("the bootstrap agrees with the delta method where the responses are straight") {
  const ResponseSystem system = linear_system();
  const Point x = least_misses(system, {0.0, 0.0});
  const ConfidenceRegion region = confidence_region(system, x, 0.95, 1.4);
  const BootstrapRegion boot = bootstrap_region(system, x, 0.95, 1.4, {2000, 7});
  CHECK(boot.lost == 0);
  for (std::size_t j = 0; j < 2; ++j) {
    // A 2.5 % percentile of 2000 draws is uncertain by 5 %; the full quadratic is not quite straight.
    CHECK(boot.upper[j] - x[j] == Approx(region.interval_upper[j] - x[j]).epsilon(0.15));
    CHECK(x[j] - boot.lower[j] == Approx(x[j] - region.interval_lower[j]).epsilon(0.15));
  }
  const BootstrapRegion again = bootstrap_region(system, x, 0.95, 1.4, {2000, 7});
  CHECK(again.lower == boot.lower);
}

TEST_CASE("the joint region holds the truth in 95 of 100 cases") {
  int held = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) held += in_joint_region(linear_system(seed), {0.0, 0.0}, 0.95);
  CHECK(held == Approx(380).margin(13));  // three standard deviations of a count
  CHECK_FALSE(in_joint_region(linear_system(), {1.0, -1.0}, 0.95));
}
