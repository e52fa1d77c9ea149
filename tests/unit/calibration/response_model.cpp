#include "core/calibration/response_model.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "core/base/error.hpp"
#include "tests/unit/calibration/examples.hpp"

using namespace asperity;
using examples::Point;

namespace {

std::map<std::string, AnovaLine> by_source(const Anova& anova) {
  std::map<std::string, AnovaLine> lines;
  for (const AnovaLine& line : anova.lines) lines[line.source] = line;
  return lines;
}

const DataCalibration& paper() {
  static const DataCalibration calibration = read_data_calibration(examples::kTable4);
  return calibration;
}

ResponseModel paper_model(std::size_t response) {
  return fit_response(paper().design, paper().responses.list[response], {});
}

/// y = 10 + 3 x1 - 2 x2 + 1.5 x1 x2 + x1^2, nothing of x3.
double four_terms(const Point& x) { return 10.0 + 3.0 * x[0] - 2.0 * x[1] + 1.5 * x[0] * x[1] + x[0] * x[0]; }

/// x1 acts only through its interaction with x2.
double interaction_only(const Point& x) { return 10.0 + 2.0 * x[1] + 1.5 * x[0] * x[1]; }

std::vector<std::string> names_of(const LinearFit& fit) {
  std::vector<std::string> names;
  for (const Term& term : fit.terms) names.push_back(term_name(term));
  return names;
}

}  // namespace

TEST_CASE("Table 4's coefficients and R2 are the paper's") {
  // As printed, and the second x1x3 of Eq 17 taken as x2x3; 0.006: half a printed digit, and 1.80 for 1.795.
  const std::vector<std::vector<double>> printed{{.75, .28, .14, .03, .11, .07, -.03, -.05, -.12, -.002},
                                                 {1.80, .48, .09, .15, -.15, -.10, .11, .04, -.37, -.12},
                                                 {57.77, -5.53, 12.28, 4.17, 5.43, 1.47, -2.82, -.75, -1.77, 1.12}};
  const double r2[3] = {0.952, 0.920, 0.965};
  for (std::size_t r = 0; r < 3; ++r) {
    const ResponseModel model = paper_model(r);
    for (std::size_t i = 0; i < 10; ++i) CHECK(model.full.coefficients[i] == Approx(printed[r][i]).margin(0.006));
    CHECK(model.full.r2 == Approx(r2[r]).margin(0.0006));
  }
}

TEST_CASE("the analysis of variance adds up") {
  for (std::size_t r = 0; r < 3; ++r) {
    const ResponseModel model = paper_model(r);
    auto line = by_source(model.anova);
    const auto sum = [&](const char* source) { return line.at(source).sum_of_squares; };
    const auto df = [&](const char* source) { return line.at(source).df; };
    const double total = sum("total");
    CHECK(sum("linear") + sum("interactions") + sum("quadratic") == Approx(sum("model")));
    CHECK(sum("model") + sum("residual") == Approx(total));
    CHECK(sum("lack_of_fit") + sum("pure_error") == Approx(sum("residual")));
    CHECK(df("linear") + df("interactions") + df("quadratic") == df("model"));
    CHECK(df("model") + df("residual") == df("total"));
    CHECK(df("lack_of_fit") + df("pure_error") == df("residual"));
    CHECK(df("pure_error") == 5);
    CHECK(line.at("model").f.value() == Approx(sum("model") / 9 / (sum("residual") / 10)));
    CHECK(line.at("x1").p.value() == Approx(model.full.p_values[1]));  // F of one term is its t squared
    CHECK(model.anova.lack_of_fit->f == Approx(sum("lack_of_fit") / 5 / (sum("pure_error") / 5)));
  }
}

TEST_CASE("pure error of the centre points, by hand") {
  // sigma_t: 0.70 0.63 0.80 0.90 0.71 0.79, mean 0.755; squares of the misses .003025 .015625 .002025 .021025 .002025
  // .001225
  const Observations observed = observe(paper().design, paper().responses.list[0]);
  CHECK(pure_error(observed)->sum_of_squares == Approx(0.04495));
  CHECK(pure_error(observed)->df == 5);
}

TEST_CASE("without repeated runs there is no pure error and no test of the fit") {
  Design design = examples::plain_design(3);
  design.coded.resize(15);
  const Response response = examples::response_of("y", design, four_terms, 0.02);
  const ResponseModel model = fit_response(design, response, {});
  CHECK_FALSE(model.anova.pure_error);
  CHECK_FALSE(model.anova.lack_of_fit);
}

TEST_CASE("elimination finds the terms that are there") {
  const Design design = examples::plain_design(3);
  int exact = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const ResponseModel model = fit_response(design, examples::response_of("y", design, four_terms, 0.02, seed), {});
    for (const char* there : {"x1", "x2", "x1x2", "x1^2"}) {
      const std::vector<std::string> names = names_of(model.reduced);
      CHECK(std::count(names.begin(), names.end(), there) == 1);
    }
    exact += model.reduced.terms.size() == 5;
    CHECK(model.reduced.terms.size() + model.eliminated.size() == 10);
    CHECK(model.reduced.r2_predicted.value() > model.full.r2_predicted.value() - 0.02);
  }
  // Five idle terms at 5 % each: 0.95^5 = 0.77 of the repetitions keep none; 10 of 20 or more with probability 0.998.
  CHECK(exact >= 10);
}

TEST_CASE("a hierarchical model keeps the linear term of an interaction, a free one need not") {
  const Design design = examples::plain_design(3);
  const Response response = examples::response_of("y", design, interaction_only, 0.01, 5);
  CHECK(names_of(fit_response(design, response, {0.01, Hierarchy::hierarchical}).reduced) ==
        std::vector<std::string>{"1", "x1", "x2", "x1x2"});
  CHECK(names_of(fit_response(design, response, {0.01, Hierarchy::free}).reduced) ==
        std::vector<std::string>{"1", "x2", "x1x2"});
  CHECK(fit_response(design, response, {1.0, Hierarchy::free}).eliminated.empty());
}

TEST_CASE("bad runs are left out and keep their rows") {
  const Design design = examples::plain_design(3);
  Response response = examples::response_of("y", design, four_terms, 0.02);
  response.values[3] = std::nan("");
  response.values[17] = std::nan("");
  const ResponseModel model = fit_response(design, response, {});
  CHECK(model.full.rows.size() == 18);
  CHECK(model.full.rows[3] == 4);
  CHECK(model.full.residual_df == 8);
  for (std::size_t i = 0; i < 18; ++i) {
    CHECK(model.full.fitted[i] + model.full.residuals[i] == Approx(response.values[model.full.rows[i]]));
  }
  CHECK(model.full.coefficients[1] == Approx(3.0).margin(0.3));
}

TEST_CASE("a response may be modelled as its logarithm") {
  const Design design = examples::plain_design(2);
  Response response =
      examples::response_of("y", design, [](const Point& x) { return 2.0 * std::exp(0.5 * x[0] - 0.2 * x[1] * x[1]); });
  response.transform = Transform::logarithm;
  const ResponseModel model = fit_response(design, response, {1.0, Hierarchy::hierarchical});
  CHECK(model.full.coefficients[0] == Approx(std::log(2.0)));
  const Point x{0.7, -0.4};
  const double y = 2.0 * std::exp(0.35 - 0.032);
  CHECK(predict_value(model, x) == Approx(y));
  CHECK(predict_gradient(model, x)[0] == Approx(0.5 * y));
  CHECK(predict_gradient(model, x)[1] == Approx(0.16 * y));
  response.values[2] = -1.0;
  CHECK_THROWS_WITH(fit_response(design, response, {}), Catch::Contains("/responses/y/2: has no logarithm"));
}

TEST_CASE("the interval of a prediction holds 95 of 100 new runs") {
  const Design design = examples::plain_design(2);
  const auto truth = [](const Point& x) { return 10.0 + x[0] + 2.0 * x[1] + x[0] * x[1]; };
  const Point x{0.5, -0.5};
  RandomStream random(3, "new runs");
  int held = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    Response response{"y", {}, Transform::none};
    for (const Point& point : design.coded) response.values.push_back(truth(point) + 0.3 * random.normal());
    const Prediction p = predict(fit_response(design, response, {1.0, Hierarchy::free}), x, 0.95);
    const double fresh = truth(x) + 0.3 * random.normal();
    held += fresh > p.lower && fresh < p.upper;
    CHECK(p.sd_run > p.sd_mean);
  }
  CHECK(held == Approx(950).margin(21));  // three standard deviations of a count
}

TEST_CASE("a run far off shows in the residual checks, and so does drift") {
  const Design design = examples::plain_design(3);
  Response response = examples::response_of("y", design, four_terms, 0.01, 2);
  CHECK(fit_response(design, response, {}).residual_checks.normality_p > 0.05);
  Response off = response;
  off.values[16] += 3.0;
  const ResidualChecks checks = fit_response(design, off, {}).residual_checks;
  CHECK(checks.row_of_largest == 16);
  CHECK(checks.largest_studentised > 5.0);
  CHECK(checks.normality_p < 0.01);
  Response drift = response;
  for (std::size_t i = 0; i < 20; ++i) drift.values[i] += 0.3 * static_cast<double>(i);
  CHECK(fit_response(design, drift, {}).residual_checks.run_order_correlation > 0.3);
}
