#include "core/calibration/design.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/error.hpp"
#include "tests/unit/calibration/examples.hpp"

using namespace asperity;

namespace {

std::string message_of(std::vector<Factor> factors) {
  try {
    central_composite(std::move(factors), StarDistance::rotatable);
    return {};
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::config);
    return error.what();
  }
}

}  // namespace

TEST_CASE("three factors give the rows of the paper's Table 4 and the levels of its Table 3") {
  const DataCalibration paper = read_data_calibration(examples::kTable4);
  const Design design = central_composite(paper.design.factors, StarDistance::rotatable);
  REQUIRE(design.coded.size() == 20);
  for (std::size_t i = 0; i < 20; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      CHECK(design.coded[i][j] == Approx(paper.design.coded[i][j]).margin(0.0005));  // printed as 1.682
    }
    CHECK(design.kind[i] == paper.design.kind[i]);
  }
  const double levels[3][5] = {
      {0.76, 2.4, 4.80, 7.20, 8.84}, {0.60, 1.88, 3.75, 5.63, 6.90}, {29.91, 34, 40, 46, 50.09}};
  const double coded[5] = {-design.alpha, -1, 0, 1, design.alpha};
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = 0; i < 5; ++i) {
      // Printed to 0.01; 3.75 - 1.875 = 1.875 is printed as 1.88.
      CHECK(decode(design.factors[j], coded[i]) == Approx(levels[j][i]).margin(0.00501));
    }
  }
}

TEST_CASE("corners, stars and centres for one, two and five factors") {
  for (std::size_t k : {1u, 2u, 5u}) {
    const Design design = central_composite(examples::plain_factors(k), StarDistance::rotatable, 4);
    const std::size_t corners = std::size_t(1) << k;
    REQUIRE(design.coded.size() == corners + 2 * k + 4);
    CHECK(design.coded.front() == std::vector<double>(k, -1.0));
    CHECK(design.coded[1].front() == 1.0);
    for (std::size_t j = 0; j < k; ++j) {
      CHECK(design.coded[corners + 2 * j][j] == -design.alpha);
      CHECK(design.coded[corners + 2 * j + 1][j] == design.alpha);
    }
    CHECK(design.coded.back() == std::vector<double>(k, 0.0));
    CHECK(design.kind.back() == PointKind::centre);
    CHECK(std::pow(design.alpha, 4) == Approx(static_cast<double>(corners)));
  }
}

TEST_CASE("the spherical distance is that of the corners") {
  CHECK(star_distance(3, StarDistance::rotatable) == Approx(1.681793));
  CHECK(star_distance(3, StarDistance::spherical) == Approx(1.732051));
  CHECK(star_distance(2, StarDistance::spherical) == Approx(star_distance(2, StarDistance::rotatable)));
}

TEST_CASE("real values go linearly or by ratios with the coded level, and back") {
  Factor factor = examples::plain_factors(2)[1];
  CHECK(decode(factor, 1.5) == 23.0);
  CHECK(encode(factor, 23.0) == 1.5);
  factor.scale = FactorScale::logarithmic;
  CHECK(decode(factor, 2.0) == 80.0);
  CHECK(decode(factor, -1.0) == 10.0);
  CHECK(encode(factor, 80.0) == Approx(2.0));
}

TEST_CASE("every fault of the factors is told with its place") {
  std::vector<Factor> factors = examples::plain_factors(4);
  factors[0].step = 0.0;
  factors[1].pointer = factors[0].pointer;
  factors[2].lower = 40.0;
  factors[2].upper = 20.0;
  factors[3].upper = 45.0;  // the star stands at 40 + 2 * 4
  const std::string message = message_of(factors);
  CHECK_THAT(message, Catch::Contains("/factors/0/step: is no step (found 0; allowed: above 0)"));
  CHECK_THAT(message, Catch::Contains("/factors/1/pointer: names a factor twice"));
  CHECK_THAT(message, Catch::Contains("/factors/2/lower: is not below the upper limit"));
  CHECK_THAT(message, Catch::Contains("/factors/3/step: puts the upper star point beyond the limit, at (found 48"));
  CHECK_THAT(message_of({}), Catch::Contains("/factors: has the wrong number of factors"));
  std::vector<Factor> ratio = examples::plain_factors(1);
  ratio[0].scale = FactorScale::logarithmic;
  CHECK_THAT(message_of(ratio), Catch::Contains("/factors/0/step: is no ratio"));
}
