#include "core/confrontation/scatter.hpp"

#include <catch2/catch.hpp>

#include "core/confrontation/conclusion.hpp"
#include "tests/support/toy_laboratory.hpp"

using namespace asperity;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr Index kCause = 2;
constexpr double kFar = 1.2;

/// Specimens of one kind of feature scatter `times` as much as runs do.
Evidence with_rough_kind(const toy::World& world, std::uint64_t draw, Index kind, double times) {
  Evidence evidence = toy::evidence(world, toy::nothing(world), draw);
  for (TestEvidence& test : evidence.tests) {
    const double mean = test.measured.col(kind).mean();
    test.measured.col(kind) = (times * (test.measured.col(kind).array() - mean) + mean).matrix();
  }
  return evidence;
}

/// Beyond the first runs' amplitude the cause's effect grows at half the rate; the data have it at amplitude 1.
Evidence with_bend(const toy::World& world, std::uint64_t draw) {
  toy::Hidden hidden = toy::nothing(world);
  hidden.amplitudes(kCause) = 0.6 + 0.5 * 0.4;
  Evidence evidence = toy::evidence(world, hidden, draw);
  evidence.candidates[kCause].far = kFar;
  for (TestEvidence& test : evidence.tests) {
    const MatrixXd base = test.base.topRows(world.common), change = test.mechanism[kCause] - base;
    test.far.assign(static_cast<std::size_t>(world.candidates), MatrixXd(0, world.features));
    test.far[kCause] = base + 1.5 * change;
  }
  return evidence;
}

}  // namespace

TEST_CASE("a kind of feature that specimens scatter much more than runs do leaves the others as they are") {
  const toy::World world;
  const Evidence evidence = with_rough_kind(world, 1, 3, 30.0);
  const Comparison rough = compare(evidence, TestUse::fit);
  const VectorXd factor = scatter_of(rough, {}).specimen_factor;
  for (Index i = 0; i < factor.size(); ++i) {
    CAPTURE(i, factor(i));
    if (rough.group[static_cast<std::size_t>(i)] == 3)
      CHECK(factor(i) > 20.0);
    else
      CHECK(factor(i) < 1.5);
  }
}

TEST_CASE("what instruments' zeros and rows' noise add to specimens is not taken for rougher rock") {
  const toy::World world;
  Evidence evidence = with_rough_kind(world, 1, 3, 10.0);
  for (TestEvidence& test : evidence.tests) {
    test.own_sd = VectorXd::Zero(world.features);
    test.own_sd(3) = 30.0;
  }
  const Comparison comparison = compare(evidence, TestUse::fit);
  const VectorXd factor = scatter_of(comparison, {}).specimen_factor;
  CHECK(factor.maxCoeff() < 1.5);
}

TEST_CASE("what is not known of the parameters' effects counts by the square of the way") {
  const toy::World world;
  const Evidence evidence = toy::evidence(world, toy::nothing(world), 1);
  const Comparison comparison = compare(evidence, TestUse::fit);
  const VectorXd way = VectorXd::Unit(world.parameters, 1) * 3.0;
  const Scatter there = scatter_at(comparison, way, {}), here = scatter_at(comparison, 0.0 * way, {});
  CHECK(here.covariance == scatter_of(comparison, {}).covariance);
  const MatrixXd& rows = comparison.jacobian_rows[1];
  const double n = static_cast<double>(rows.rows());
  for (const Index i : {Index{0}, Index{13}}) {
    const double variance = rows.col(i).squaredNorm() / (n - 1.0);
    CHECK(there.covariance(i, i) - here.covariance(i, i) == Approx(9.0 * variance / n));
  }
  CHECK(there.effects(0, world.features) == 0.0);  // meshes of two tests know nothing of each other
}

TEST_CASE("of an effect that bends the amplitude is found on the farther runs") {
  const toy::World world;
  double bent = 0.0, straight = 0.0;
  for (std::uint64_t draw = 0; draw < 10; ++draw) {
    Evidence evidence = with_bend(world, draw);
    const auto fitted = [&] {
      const Comparison comparison = compare(evidence, TestUse::fit);
      const Scatter scatter = scatter_of(comparison, {});
      const BaseFit base = calibrate_base(comparison, scatter.covariance, evidence.parameters);
      return fit_hypothesis(scatter.covariance, evidence.candidates, linear_hypothesis(comparison, base, {kCause}));
    };
    bent += fitted().amplitude(0) / 10.0;
    for (TestEvidence& test : evidence.tests) test.far.clear();
    straight += fitted().amplitude(0) / 10.0;
  }
  CHECK(bent == Approx(1.0).margin(0.06));
  CHECK(straight == Approx(0.8).margin(0.06));
}

TEST_CASE("what a cause does is the runs' own at both of its amplitudes, with their error") {
  const toy::World world;
  const Evidence evidence = with_bend(world, 4);
  const Comparison c = compare(evidence, TestUse::fit);
  const Index first = world.features;  // the second test's
  const TestEvidence& test = evidence.tests[1];
  for (const auto& [amplitude, runs] : {std::pair{0.6, &test.mechanism[kCause]}, {kFar, &test.far[kCause]}}) {
    const MatrixXd change = *runs - test.base.topRows(world.common);
    const MatrixXd rows = effect_rows(c, kCause, amplitude).middleCols(first, world.features);
    CHECK(
        (effect_of(c, kCause, amplitude).segment(first, world.features) - change.colwise().mean().transpose()).norm() ==
        Approx(0.0).margin(1e-12));
    CHECK((rows - (change.rowwise() - change.colwise().mean())).norm() == Approx(0.0).margin(1e-12));
  }
  CHECK(effect_of(c, kCause, -0.3) == -0.3 * c.fingerprint.col(kCause));
  CHECK(std::isinf(c.knee(0)));
  CHECK(secant_of(c, 0) == c.fingerprint.col(0));
}

TEST_CASE("a cause that a pair does not need makes no pair") {
  HypothesisFit fit;
  fit.amplitude = fit.amplitude_error = VectorXd::Constant(2, 0.1);
  fit.amplitude(0) = 0.8;
  CHECK_FALSE(both_act(fit));
  fit.amplitude(1) = 0.0;
  CHECK_FALSE(both_act(fit));
  fit.amplitude(1) = -0.3;
  CHECK(both_act(fit));
}

TEST_CASE("an effect at its detectable amplitude is seen more often than not, one of a third of it seldom") {
  const toy::World world;
  const auto gate_of = [&](double amplitude, std::uint64_t draw) {
    toy::Hidden hidden = toy::nothing(world);
    hidden.amplitudes(kCause) = amplitude;
    const Evidence evidence = toy::evidence(world, hidden, draw);
    const Comparison comparison = compare(evidence, TestUse::fit);
    const Scatter scatter = scatter_of(comparison, {});
    GateOptions options;
    options.draws = 200;
    return gate(comparison, scatter, calibrate_base(comparison, scatter.covariance, evidence.parameters),
                evidence.candidates, options);
  };
  int seen = 0, faint = 0;
  for (std::uint64_t draw = 0; draw < 20; ++draw) {
    const double detectable = gate_of(0.0, draw).detectable(kCause);
    seen += gate_of(detectable, draw + 50).discrepancy;
    faint += gate_of(detectable / 3.0, draw + 50).discrepancy;
  }
  CAPTURE(seen, faint);
  CHECK(seen >= 12);
  CHECK(faint <= 4);
}
