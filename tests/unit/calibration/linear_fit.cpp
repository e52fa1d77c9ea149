#include "core/calibration/linear_fit.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <openturns/LinearBasisFactory.hxx>
#include <openturns/LinearModelAlgorithm.hxx>
#include <openturns/LinearModelAnalysis.hxx>

#include "core/base/error.hpp"
#include "core/calibration/response_model.hpp"
#include "tests/unit/calibration/examples.hpp"

using namespace asperity;

namespace {

constexpr double kRounding = 1e-9;  // relative: some hundred operations in double precision

/// y = 1 + 2 x with misses +-1: by hand, slope 2, intercept 1, residual sum of squares 4.
Observations line() { return {"line", {0, 1, 2, 3}, {{-1.0}, {-1.0}, {1.0}, {1.0}}, {0.0, -2.0, 4.0, 2.0}}; }

}  // namespace

TEST_CASE("names, values and slopes of the terms of a quadratic") {
  const std::vector<Term> terms = quadratic_terms(3);
  const std::vector<std::string> names{"1", "x1", "x2", "x3", "x1x2", "x1x3", "x2x3", "x1^2", "x2^2", "x3^2"};
  const std::vector<double> x{2.0, 3.0, 5.0}, values{1, 2, 3, 5, 6, 10, 15, 4, 9, 25},
      slopes{0, 0, 1, 0, 2, 0, 5, 0, 6, 0};
  REQUIRE(terms.size() == 10);
  for (std::size_t i = 0; i < 10; ++i) {
    CHECK(term_name(terms[i]) == names[i]);
    CHECK(term_value(terms[i], x) == values[i]);
    CHECK(term_derivative(terms[i], x, 1) == slopes[i]);
  }
  CHECK(is_parent(terms[1], terms[4]));
  CHECK(is_parent(terms[1], terms[7]));
  CHECK_FALSE(is_parent(terms[1], terms[6]));
  CHECK_FALSE(is_parent(terms[1], terms[2]));
}

TEST_CASE("a straight line through four points, by hand") {
  const LinearFit fit = fit_terms(line(), {{}, {0, -1}});
  CHECK(fit.coefficients[0] == Approx(1.0));
  CHECK(fit.coefficients[1] == Approx(2.0));
  CHECK(fit.residual_sum_of_squares == Approx(4.0));
  CHECK(fit.residual_df == 2);
  CHECK(fit.residual_sd == Approx(std::sqrt(2.0)));
  CHECK(fit.standard_errors[1] == Approx(std::sqrt(0.5)));  // sqrt(s^2 / sum x^2) = sqrt(2 / 4)
  CHECK(fit.t_values[1] == Approx(2.0 / std::sqrt(0.5)));
  CHECK(fit.p_values[1] ==
        Approx(2.0 * (0.5 - 0.5 * std::sqrt(8.0) / std::sqrt(10.0))));  // Student with 2 df in closed form
  CHECK(fit.total_sum_of_squares == Approx(20.0));
  CHECK(fit.r2 == Approx(0.8));
  CHECK(fit.r2_adjusted == Approx(0.7));  // 1 - (4 / 2) / (20 / 3)
  CHECK(fit.leverages[0] == Approx(0.5));
  CHECK(fit.r2_predicted.value() ==
        Approx(1.0 - 16.0 / 20.0));  // each residual 1 over 1 - h = 0.5, squared, four times
  // s^2 without the run: (2 * 2 - 1 / 0.5) / 1 = 2; 1 / sqrt(2 * 0.5) = 1
  CHECK(std::abs(fit.studentised[0]) == Approx(1.0));
}

TEST_CASE("Table 4's full quadratics agree with OpenTURNS' own linear model analysis") {
  const DataCalibration paper = read_data_calibration(examples::kTable4);
  for (const Response& response : paper.responses.list) {
    const Observations observed = observe(paper.design, response);
    const LinearFit fit = fit_terms(observed, quadratic_terms(3));
    OT::Sample columns(20, 9), values(20, 1);
    for (std::size_t i = 0; i < 20; ++i) {
      for (std::size_t j = 1; j < 10; ++j) columns(i, j - 1) = term_value(fit.terms[j], observed.x[i]);
      values(i, 0) = observed.y[i];
    }
    OT::LinearModelAlgorithm algorithm(columns, values);
    const OT::LinearModelResult result = algorithm.getResult();
    const OT::LinearModelAnalysis analysis(result);
    for (std::size_t j = 0; j < 10; ++j) {
      CHECK(fit.coefficients[j] == Approx(result.getCoefficients()[j]).epsilon(kRounding));
      CHECK(fit.standard_errors[j] == Approx(result.getCoefficientsStandardErrors()[j]).epsilon(kRounding));
      CHECK(fit.p_values[j] == Approx(analysis.getCoefficientsPValues()[j]).epsilon(1e-6).margin(1e-12));  // far tails
    }
    for (std::size_t i = 0; i < 20; ++i) CHECK(fit.leverages[i] == Approx(result.getLeverages()[i]).epsilon(kRounding));
    CHECK(fit.r2 == Approx(result.getRSquared()).epsilon(kRounding));
    CHECK(fit.r2_adjusted == Approx(result.getAdjustedRSquared()).epsilon(kRounding));
  }
}

TEST_CASE("predicted R2 and studentised residuals are those of fits without the run") {
  const DataCalibration paper = read_data_calibration(examples::kTable4);
  const Observations all = observe(paper.design, paper.responses.list[1]);
  const LinearFit fit = fit_terms(all, quadratic_terms(3));
  double press = 0.0;
  for (std::size_t i = 0; i < 20; ++i) {
    Observations rest = all;
    const auto gone = static_cast<std::ptrdiff_t>(i);
    rest.rows.erase(rest.rows.begin() + gone);
    rest.x.erase(rest.x.begin() + gone);
    rest.y.erase(rest.y.begin() + gone);
    const LinearFit without = fit_terms(rest, fit.terms);
    const double miss = all.y[i] - evaluate(without, all.x[i]);
    press += miss * miss;
    CHECK(fit.studentised[i] ==
          Approx(fit.residuals[i] / (without.residual_sd * std::sqrt(1.0 - fit.leverages[i]))).epsilon(1e-7));
  }
  CHECK(fit.r2_predicted.value() == Approx(1.0 - press / fit.total_sum_of_squares).epsilon(kRounding));
}

TEST_CASE("too few runs, and runs that cannot tell terms apart, are named errors") {
  Observations few = line();
  few.rows.pop_back();
  few.rows.pop_back();
  few.x.resize(2);
  few.y.resize(2);
  CHECK_THROWS_WITH(fit_terms(few, {{}, {0, -1}}), Catch::Contains("/responses/line: has too few good runs") &&
                                                       Catch::Contains("found 2; allowed: 3 or more"));
  CHECK_THROWS_WITH(fit_terms(line(), {{}, {0, -1}, {0, 0}}), Catch::Contains("cannot tell the model's terms apart"));
}

TEST_CASE("exact data have p values of 1 for terms that are rounding, and no residual checks") {
  const Design design = examples::plain_design(3);
  const Response exact =
      examples::response_of("exact", design, [](const examples::Point& x) { return 5.0 + 2.0 * x[0]; });
  const ResponseModel model = fit_response(design, exact, {0.05, Hierarchy::hierarchical});
  CHECK(model.reduced.terms.size() == 2);
  CHECK(model.eliminated.size() == 8);
  CHECK(std::isnan(model.residual_checks.normality_p));
}
