#include "core/calibration/emulator.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/calibration/refinement.hpp"
#include "tests/unit/calibration/examples.hpp"

using namespace asperity;
using examples::Point;

namespace {

double hill(const Point& x) { return 5.0 + std::exp(0.4 * x[0]) + std::sin(x[1]) + 0.3 * x[0] * x[1]; }
double ramp(const Point& x) { return 20.0 + 3.0 * x[1] - std::exp(-0.5 * x[0]); }

Emulator emulator_of(double scatter) {
  const Design design = examples::plain_design(2);
  const Response response = examples::response_of("y", design, hill, scatter / 6.0);
  return {design.coded, response.values, std::max(scatter, 1e-6)};
}

Batch batch_at(const Point& x, RandomStream& random) {
  Batch batch{x, {}};
  for (int i = 0; i < 3; ++i) batch.y.push_back({hill(x) + 0.02 * random.normal(), ramp(x) + 0.05 * random.normal()});
  return batch;
}

Refinement started(const Point& truth, const RefinementOptions& options) {
  const Design design = examples::plain_design(2);
  RandomStream random(1, "design");
  std::vector<std::vector<double>> y;
  for (const Point& x : design.coded) y.push_back({hill(x) + 0.02 * random.normal(), ramp(x) + 0.05 * random.normal()});
  return start_refinement({examples::target_of("a", hill(truth)), examples::target_of("b", ramp(truth))}, {0.02, 0.05},
                          design.coded, y, options);
}

}  // namespace

TEST_CASE("without scatter the emulator passes through its runs and knows it") {
  const Emulator emulator = emulator_of(0.0);
  for (const Point& x : examples::plain_design(2).coded) {
    CHECK(emulator.mean(x) == Approx(hill(x)).margin(0.01));  // the least noise, 1e-3 of 2.2, and some
    CHECK(std::sqrt(emulator.variance(x)) < 0.003);
  }
  for (const Point& x : {Point{0.5, -0.4}, Point{-0.7, 0.2}, Point{0.1, 0.9}}) {  // between the runs
    CHECK(emulator.mean(x) == Approx(hill(x)).margin(3.0 * std::sqrt(emulator.variance(x))));
    CHECK(std::sqrt(emulator.variance(x)) < 0.25);  // of a range of 4
  }
  CHECK(emulator.variance({4.0, 4.0}) > 10.0 * emulator.variance({0.5, 0.5}));
}

TEST_CASE("with scatter it smooths repeated runs") {
  const Emulator emulator = emulator_of(0.3);
  const double at_centre = std::sqrt(emulator.variance({0.0, 0.0}));
  CHECK(at_centre < 0.3 / std::sqrt(6.0) * 1.01);  // six runs there, and neighbours that tell a little more
  CHECK(at_centre > 0.5 * 0.3 / std::sqrt(6.0));
  CHECK(emulator.mean({0.0, 0.0}) == Approx(hill({0.0, 0.0})).margin(3.0 * at_centre));
}

TEST_CASE("its gradient is its mean's slope; of a plane it is the plane's") {
  const Design design = examples::plain_design(2);
  const auto plane = [](const Point& x) { return 4.0 + 3.0 * x[0] - 2.0 * x[1]; };
  const Emulator flat(design.coded, examples::response_of("y", design, plane).values, 1e-6);
  CHECK(flat.gradient({0.3, 0.2})[0] == Approx(3.0).margin(1e-3));
  CHECK(flat.gradient({0.3, 0.2})[1] == Approx(-2.0).margin(1e-3));
  const Emulator emulator = emulator_of(0.0);
  const double rise = emulator.mean({0.31, 0.2}) - emulator.mean({0.29, 0.2});
  CHECK(emulator.gradient({0.3, 0.2})[0] == Approx(rise / 0.02).margin(1e-3));  // its third derivative times 1e-4
}

TEST_CASE("the refinement finds known parameters in a few batches and stops within scatter") {
  const Point truth{0.7, -0.5};
  RefinementOptions options;
  options.region = {RegionShape::sphere, std::sqrt(2.0)};
  Refinement refinement = started(truth, options);
  RandomStream random(2, "batches");
  while (!refinement.done) refinement = update(refinement, batch_at(propose(refinement), random), options);
  CHECK(refinement.steps.size() <= 4);
  CHECK(refinement.steps.back().within_noise);
  CHECK(refinement.steps.back().within_tolerance);
  for (std::size_t j = 0; j < 2; ++j) {
    const double sd = std::sqrt(refinement.covariance[3 * j]);
    CHECK(sd < 0.1);
    CHECK(refinement.theta[j] == Approx(truth[j]).margin(4.0 * sd));
  }
  CHECK(best_step(refinement) != nullptr);
  CHECK(refinement.x.size() == 14 + 3 * refinement.steps.size());
}

TEST_CASE("out of reach, the refinement stops after the stated steps at the design's rim") {
  RefinementOptions options;
  options.region = {RegionShape::sphere, std::sqrt(2.0)};
  options.most_steps = 3;
  Refinement refinement = started({3.0, 3.0}, options);
  RandomStream random(2, "batches");
  while (!refinement.done) refinement = update(refinement, batch_at(propose(refinement), random), options);
  CHECK(refinement.steps.size() == 3);
  CHECK_FALSE(refinement.steps.back().within_noise);
  CHECK(inside(options.region, refinement.theta));
}

TEST_CASE("the misfit is chi squared of the batch's mean, by hand") {
  RefinementOptions options;
  options.region = {RegionShape::sphere, std::sqrt(2.0)};
  Refinement refinement = started({0.0, 0.0}, options);
  const double a = refinement.targets[0].value, b = refinement.targets[1].value;
  const double none = std::nan("");
  refinement = update(refinement, {{0.1, 0.1}, {{a + 0.02, b}, {a + 0.04, b + 0.1}, {none, none}}}, options);
  // two runs: misses 0.03 and 0.05, variances 0.02^2 / 2 and 0.05^2 / 2: 4.5 + 2
  CHECK(refinement.steps[0].chi2 == Approx(6.5));
  CHECK(refinement.steps[0].runs == 2);
  CHECK_FALSE(refinement.steps[0].within_noise);  // 95 % of chi squared with 2 degrees of freedom is 5.99
}
