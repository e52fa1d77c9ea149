#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/random.hpp"
#include "core/calibration/analysis.hpp"
#include "tests/unit/calibration/examples.hpp"

using namespace asperity;
using examples::Point;

// The whole statistical layer on a model whose parameters are known: design, noisy runs, fits, solution, region.
namespace {

constexpr double kScatter = 0.03;  // of one mesh: what 2 mm triangles show
constexpr int kMeshes = 5;         // behind each target
constexpr int kRepetitions = 20;

/// Smooth, and no quadratics: exponentials, a hyperbolic tangent, a product.
std::vector<double> macro(const Point& x) {
  return {1.0 * std::exp(0.30 * x[0]) * (1.0 + 0.10 * std::tanh(x[1])),
          1.8 * (1.0 + 0.25 * x[1] + 0.08 * x[0]) * std::exp(0.04 * x[2]),
          45.0 + 6.0 * x[2] + 4.0 * std::tanh(0.7 * x[0]) - 1.0 * x[1] * x[2]};
}

/// One mesh: the second and third response come from one line, so their scatter is opposed.
std::vector<double> run(const Point& x, RandomStream& random) {
  std::vector<double> y = macro(x);
  const double shared = random.normal();
  y[0] *= 1.0 + kScatter * random.normal();
  y[1] *= 1.0 + kScatter * shared;
  y[2] *= 1.0 + kScatter * (-0.8 * shared + 0.6 * random.normal());
  return y;
}

const std::vector<std::string> kNames{"tensile_strength_mpa", "cohesion_mpa", "friction_angle_deg"};

std::vector<Target> measured(const Point& truth, RandomStream& random) {
  std::vector<double> mean(3, 0.0);
  for (int i = 0; i < kMeshes; ++i) {
    const std::vector<double> y = run(truth, random);
    for (std::size_t r = 0; r < 3; ++r) mean[r] += y[r] / kMeshes;
  }
  std::vector<Target> targets;
  for (std::size_t r = 0; r < 3; ++r) {
    targets.push_back(examples::target_of(kNames[r], mean[r]));
    targets[r].standard_error = kScatter * mean[r] / std::sqrt(kMeshes);
  }
  return targets;
}

Responses simulated(const Design& design, RandomStream& random) {
  Responses responses;
  for (const std::string& name : kNames) responses.list.push_back({name, {}, Transform::none});
  for (const Point& x : design.coded) {
    const std::vector<double> y = run(x, random);
    for (std::size_t r = 0; r < 3; ++r) responses.list[r].values.push_back(y[r]);
  }
  return responses;
}

Point draw_truth(RandomStream& random) {
  for (;;) {
    const Point x{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    if (x[0] * x[0] + x[1] * x[1] + x[2] * x[2] <= 1.0) return x;
  }
}

struct Recovery {
  int in_box = 0, in_joint = 0, intervals = 0, bootstrap = 0;
};

bool holds(const Point& lower, const Point& upper, const Point& x) {
  for (std::size_t j = 0; j < x.size(); ++j) {
    if (x[j] < lower[j] || x[j] > upper[j]) return false;
  }
  return true;
}

void repeat(std::uint64_t seed, Recovery& recovery) {
  RandomStream random(seed, "recovery");
  const Design design = examples::plain_design(3);
  const Point truth = draw_truth(random);
  const std::vector<Target> targets = measured(truth, random);
  AnalysisOptions options;
  options.bootstrap_draws = 200;
  const Analysis analysis = analyse(design, simulated(design, random), targets, options);
  INFO("repetition " << seed);
  REQUIRE(!analysis.solutions.empty());
  const ConfidenceRegion& region = analysis.solutions.front().region;
  const BootstrapRegion& boot = *analysis.solutions.front().bootstrap;
  recovery.in_box += holds(region.lower, region.upper, truth);
  recovery.in_joint += in_joint_region(system_of(analysis.models, targets), truth, options.level);
  for (std::size_t j = 0; j < 3; ++j) {
    recovery.intervals += truth[j] >= region.interval_lower[j] && truth[j] <= region.interval_upper[j];
    recovery.bootstrap += truth[j] >= boot.lower[j] && truth[j] <= boot.upper[j];
  }
}

}  // namespace

TEST_CASE("known parameters come back inside the stated regions in at least 18 of 20 repetitions") {
  Recovery recovery;
  for (std::uint64_t seed = 1; seed <= kRepetitions; ++seed) repeat(seed, recovery);
  CHECK(recovery.in_box >= 18);
  CHECK(recovery.in_joint >= 18);
  // 60 intervals of one parameter at 95 %: 57 expected; 54 or more with a probability of 0.93.
  CHECK(recovery.intervals >= 54);
  CHECK(recovery.bootstrap >= 54);
}
