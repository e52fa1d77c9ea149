#include "core/confrontation/hypothesis.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/confrontation/naming.hpp"
#include "tests/support/toy_laboratory.hpp"

using namespace asperity;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr Index kCause = 2;
constexpr double kNear = 0.6, kFar = 1.2, kBetween = 0.9;

/// A cause whose effect is f a + b a (a - near) in the parabola through its runs.
struct Bending {
  toy::World world;
  VectorXd straight, bent;

  Bending() {
    RandomStream random(7, "bent");
    straight = toy::directions(world).fingerprint.col(kCause);
    bent = 12.0 * toy::normals(straight.size(), 1, random).col(0);
  }
  VectorXd effect(double amplitude) const { return amplitude * straight + amplitude * (amplitude - kNear) * bent; }

  /// A laboratory with `outside` in its data, and the cause's runs at both amplitudes.
  Evidence evidence(const VectorXd& outside, std::uint64_t draw) const {
    toy::Hidden hidden = toy::nothing(world);
    hidden.outside = outside;
    Evidence evidence = toy::evidence(world, hidden, draw);
    evidence.candidates[kCause].far = kFar;
    for (std::size_t t = 0; t < evidence.tests.size(); ++t) {
      TestEvidence& test = evidence.tests[t];
      const auto own = [&](const VectorXd& all) {
        return all.segment(static_cast<Index>(t) * world.features, world.features).transpose().eval();
      };
      const MatrixXd scatter = test.mechanism[kCause].rowwise() - kNear * own(straight);
      test.far.assign(static_cast<std::size_t>(world.candidates), MatrixXd(0, world.features));
      test.far[kCause] = scatter.rowwise() + own(effect(kFar));
    }
    return evidence;
  }
};

/// Whether the cause, with and without its effect's bend, is kept.
struct Kept {
  bool with = false, without = false;
};

Kept judged(const Evidence& evidence) {
  const Comparison comparison = compare(evidence, TestUse::fit);
  const Scatter scatter = scatter_of(comparison, {});
  const BaseFit base = calibrate_base(comparison, scatter.covariance, evidence.parameters);
  const Hypothesis chords = linear_hypothesis(comparison, base, {kCause});
  NamingOptions options;
  options.draws.draws = 200;
  const auto kept = [&](const Hypothesis& h) {
    return judge(comparison, scatter, base, evidence.candidates, {h}, options).front().kept;
  };
  return {kept(with_bend(chords, comparison, scatter.covariance, evidence.candidates)), kept(chords)};
}

}  // namespace

TEST_CASE("the bend of an effect is what a parabola through its runs has beyond their chords") {
  const Bending cause;
  Evidence evidence = cause.evidence(0.0 * cause.straight, 1);
  for (std::size_t t = 0; t < evidence.tests.size(); ++t) {
    TestEvidence& test = evidence.tests[t];
    const Index first = static_cast<Index>(t) * cause.world.features;
    const MatrixXd base = test.base.topRows(cause.world.common);
    for (const auto& [runs, amplitude] : {std::pair{&test.mechanism[kCause], kNear}, {&test.far[kCause], kFar}})
      *runs = base.rowwise() + cause.effect(amplitude).segment(first, cause.world.features).transpose();
  }
  const Comparison c = compare(evidence, TestUse::fit);
  for (const double a : {0.2, 0.5, 0.7, kBetween, 1.1}) {
    const VectorXd beyond = cause.effect(a) - effect_of(c, kCause, a);
    CHECK((bend_of(c, kCause, a) - beyond).norm() < 1e-9);
    CHECK(beyond.norm() > 1.0);
  }
  for (const double a : {-0.3, 0.0, kNear, kFar, 2.0}) CHECK(bend_of(c, kCause, a).norm() < 1e-9);
  CHECK(bend_of(c, kCause + 1, kBetween).norm() == 0.0);  // has been run at one amplitude
}

TEST_CASE("a cause whose effect between its runs is off the chords by their bend is not refuted by that") {
  const Bending cause;
  RandomStream random(3, "off");
  const VectorXd chord = kBetween * cause.straight + 0.5 * kFar * (kFar - kNear) * cause.bent;
  const VectorXd bend = cause.effect(kBetween) - chord;
  int with = 0, without = 0;
  for (std::uint64_t draw = 0; draw < 10; ++draw) {
    const VectorXd off = toy::normals(bend.size(), 1, random).col(0).cwiseProduct(bend);
    const Kept kept = judged(cause.evidence(chord + off, draw));
    with += kept.with;
    without += kept.without;
  }
  CAPTURE(with, without);
  CHECK(with >= 9);
  CHECK(without <= 1);
}

TEST_CASE("a bend excuses no effect of another kind") {
  const Bending cause;
  RandomStream random(5, "outside");
  int kept = 0;
  for (std::uint64_t draw = 0; draw < 10; ++draw) {
    VectorXd outside = toy::normals(cause.straight.size(), 1, random).col(0);
    outside *= 12.0 / outside.norm();
    kept += judged(cause.evidence(outside, draw)).with;
    kept += judged(cause.evidence(cause.effect(kFar) + outside, draw)).with;
  }
  CAPTURE(kept);
  CHECK(kept <= 2);
}

TEST_CASE("a cause that would explain anything is no match for one that explains what is there") {
  toy::World world;
  toy::Hidden hidden = toy::nothing(world);
  hidden.amplitudes(kCause) = 1.0;
  const Evidence evidence = toy::evidence(world, hidden, 4);
  const Comparison comparison = compare(evidence, TestUse::fit);
  const Scatter scatter = scatter_of(comparison, {});
  const BaseFit base = calibrate_base(comparison, scatter.covariance, evidence.parameters);
  const Hypothesis truth = linear_hypothesis(comparison, base, {kCause});
  Hypothesis vague = linear_hypothesis(comparison, base, {kCause + 1});
  vague.bend = 6.0 * scatter.covariance.diagonal().array().sqrt();
  NamingOptions options;
  options.draws.draws = 200;
  const std::vector<HypothesisFit> fits =
      judge(comparison, scatter, base, evidence.candidates, {truth, vague}, options);
  CHECK(fits[1].misfit < fits[0].misfit);
  CHECK(fits[0].widening == 0.0);
  // ln det(V + 36 diag V) - ln det V is least where V is diagonal (Jensen, over the eigenvalues of its correlation).
  CHECK(fits[1].widening > static_cast<double>(truth.difference.size()) * std::log(37.0) - 1e-6);
  CHECK(fits[0].kept);
  CHECK(fits[0].excess == 0.0);
  CHECK(!fits[1].kept);
}

TEST_CASE("a hypothesis by runs is judged by the scatter of its own runs, not by that of the effect's first ones") {
  toy::World world;
  toy::Hidden hidden = toy::nothing(world);
  RandomStream random(9, "far from its first runs");
  hidden.outside = 2.0 * toy::normals(world.tests * world.features, 1, random).col(0);
  const Evidence evidence = toy::evidence(world, hidden, 1);
  const Comparison comparison = compare(evidence, TestUse::fit);
  const Scatter scatter = scatter_of(comparison, {});
  const BaseFit base = calibrate_base(comparison, scatter.covariance, evidence.parameters);
  Hypothesis h = linear_hypothesis(comparison, base, {kCause});
  h.by_runs = true;
  h.amplitude(0) = 2.4;
  NamingOptions options;
  options.draws.draws = 200;
  const MatrixXd rows = toy::normals(world.common, h.difference.size(), random);
  const auto kept = [&](double size) {
    h.run_rows = size * rows;
    return judge(comparison, scatter, base, evidence.candidates, {h}, options).front().kept;
  };
  CHECK(!kept(0.0));
  CHECK(!kept(1.0));
  CHECK(kept(10.0));
}
