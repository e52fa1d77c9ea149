#include "core/measurement/event_magnitudes.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/random.hpp"

using namespace asperity;

namespace {

/// Magnitudes whose number falls as 10^(-b M) from 0 on: exponential, by the inverse of their distribution.
std::vector<double> exponential(double b, int count, std::uint64_t seed) {
  RandomStream random(seed, "magnitudes");
  std::vector<double> magnitudes;
  for (int i = 0; i < count; ++i) magnitudes.push_back(-std::log10(1.0 - random.uniform()) / b);
  return magnitudes;
}

}  // namespace

TEST_CASE("Magnitudes of known energies") {
  // 10^4.8 J is magnitude 0, thirty-two times (10^1.5) as much 1; 1 N mm is 1 mJ.
  CHECK(event_magnitude(std::pow(10.0, 7.8)) == Approx(0.0).margin(1e-12));
  CHECK(event_magnitude(std::pow(10.0, 9.3)) == Approx(1.0).epsilon(1e-12));
  CHECK(event_magnitude(1.0) == Approx(-5.2).epsilon(1e-12));
  CHECK(event_magnitudes(std::vector<double>{1.0, 0.0, 1e3}).size() == 2);
}

TEST_CASE("The b-value of exponential magnitudes comes out within its error") {
  for (const double b : {0.7, 1.0, 1.8}) {
    double worst = 0.0, sum = 0.0, squares = 0.0, errors = 0.0;
    constexpr int kTrials = 40;
    for (int trial = 0; trial < kTrials; ++trial) {
      const auto found = magnitude_statistics(exponential(b, 400, 100 + trial));
      REQUIRE(found);
      REQUIRE(found->b);
      worst = std::max(worst, std::abs(*found->b - b) / *found->error);
      sum += *found->b;
      squares += (*found->b - b) * (*found->b - b);
      errors += *found->error;
    }
    CHECK(worst < 4.0);                               // of 40 normal deviates
    CHECK(sum / kTrials == Approx(b).epsilon(0.03));  // 40 errors of some 6 %: 1 %, with three times that
    const double scatter = std::sqrt(squares / kTrials);
    CHECK(errors / kTrials == Approx(scatter).epsilon(0.35));  // a standard deviation of 40 is known to 11 %
  }
}

TEST_CASE("Small events that were missed do not count: the completeness is where most are") {
  std::vector<double> magnitudes;
  RandomStream random(7, "missed");
  for (const double m : exponential(1.0, 4000, 7))
    if (m > 1.0 || random.uniform() < 0.1 * m) magnitudes.push_back(m);
  const auto found = magnitude_statistics(magnitudes);
  REQUIRE(found);
  CHECK(found->completeness == Approx(1.0));
  REQUIRE(found->b);
  CHECK(std::abs(*found->b - 1.0) < 3.0 * *found->error);
}

TEST_CASE("A sample below the least count has no b-value, and says how many it has") {
  const auto few = magnitude_statistics(exponential(1.0, kLeastEvents - 1, 1));
  REQUIRE(few);
  CHECK_FALSE(few->b);
  CHECK(few->events == kLeastEvents - 1);
  CHECK_FALSE(magnitude_statistics({}));
  CHECK_FALSE(magnitude_statistics(std::vector<double>(60, 1.3))->b);  // all of one magnitude
}

TEST_CASE("b and its error by hand") {
  // 25 events at 0.25 and 25 at 0.35: all in the bin from 0.2, their mean 0.1 above it.
  std::vector<double> magnitudes(25, 0.25);
  magnitudes.insert(magnitudes.end(), 25, 0.35);
  const auto found = magnitude_statistics(magnitudes);
  REQUIRE(found);
  CHECK(found->completeness == Approx(0.2));
  CHECK(*found->b == Approx(0.4342944819 / 0.1).epsilon(1e-9));
  // Sum of squares 50 * 0.05^2 = 0.125; n (n - 1) = 2450.
  CHECK(*found->error == Approx(2.302585093 * std::pow(4.342944819, 2) * std::sqrt(0.125 / 2450.0)).epsilon(1e-9));
  CHECK(found->a() == Approx(std::log10(50.0) + 0.2 * 4.342944819).epsilon(1e-9));
}
