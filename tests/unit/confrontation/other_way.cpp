#include <catch2/catch.hpp>

#include "core/confrontation/naming.hpp"
#include "tests/support/toy_laboratory.hpp"

using namespace asperity;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr Index kSetting = 2;
constexpr double kStep = 0.6;

/// A setting that may be off either way, whose effects to its two sides have nothing to do with one another.
struct Setting {
  toy::World world;
  VectorXd above, below;  ///< A unit of amplitude up and down.

  Setting() {
    RandomStream random(11, "other way");
    above = toy::directions(world).fingerprint.col(kSetting);
    below = toy::normals(above.size(), 1, random).col(0);
    below *= world.strength / below.norm();
  }
  VectorXd effect(double amplitude) const { return std::abs(amplitude) * (amplitude > 0.0 ? above : below); }

  /// A laboratory in which it is off by this amplitude, and runs on both sides; on the first alone if `one_side`.
  Evidence evidence(double amplitude, std::uint64_t draw, bool one_side = false) const {
    toy::Hidden hidden = toy::nothing(world);
    hidden.outside = effect(amplitude);
    Evidence evidence = toy::evidence(world, hidden, draw);
    evidence.candidates[kSetting].two_sided = true;
    if (one_side) return evidence;
    evidence.candidates[kSetting].far = -kStep;
    for (std::size_t t = 0; t < evidence.tests.size(); ++t) {
      TestEvidence& test = evidence.tests[t];
      const Index first = static_cast<Index>(t) * world.features;
      const VectorXd change = (effect(-kStep) - kStep * above).segment(first, world.features);
      test.far.assign(static_cast<std::size_t>(world.candidates), MatrixXd(0, world.features));
      test.far[kSetting] = test.mechanism[kSetting].rowwise() + change.transpose();
    }
    return evidence;
  }
};

/// What a comparison says of the setting alone.
struct Said {
  double explained = 0, amplitude = 0;
  VectorXd shown;  ///< Its fingerprint without what calibration absorbs, and those to both sides.
  VectorXd up, down;
  bool kept = false;
};

Said said(const Evidence& evidence) {
  const Comparison comparison = compare(evidence, TestUse::fit);
  const Scatter scatter = scatter_of(comparison, {});
  const BaseFit base = calibrate_base(comparison, scatter.covariance, evidence.parameters);
  const WhitenedFrame frame(scatter.covariance, base.absorbing);
  NamingOptions options;
  options.draws.draws = 200;
  const Hypothesis chords = linear_hypothesis(comparison, base, {kSetting});
  const HypothesisFit fit = judge(comparison, scatter, base, evidence.candidates, {chords}, options).front();
  return {pattern_of(frame, base.difference, comparison, evidence.candidates).explained(kSetting),
          fit.amplitude(0),
          projected_fingerprints(frame, base.difference, comparison).col(kSetting),
          frame.project(slope_of(comparison, kSetting, 1.0)),
          frame.project(slope_of(comparison, kSetting, -1.0)),
          fit.kept};
}

}  // namespace

TEST_CASE("what a setting does to either side is its own runs' there") {
  const Setting setting;
  const Evidence evidence = setting.evidence(0.0, 3);
  const Comparison c = compare(evidence, TestUse::fit);
  const Index first = setting.world.features;  // the second test's
  const TestEvidence& test = evidence.tests[1];
  for (const auto& [amplitude, runs] : {std::pair{kStep, &test.mechanism[kSetting]}, {-kStep, &test.far[kSetting]}}) {
    const MatrixXd change = *runs - test.base.topRows(setting.world.common);
    const VectorXd mean = change.colwise().mean().transpose();
    const MatrixXd rows = effect_rows(c, kSetting, amplitude).middleCols(first, setting.world.features);
    CHECK((effect_of(c, kSetting, amplitude).segment(first, setting.world.features) - mean).norm() < 1e-12);
    CHECK((effect_of(c, kSetting, 2.0 * amplitude).segment(first, setting.world.features) - 2.0 * mean).norm() < 1e-12);
    CHECK((rows - (change.rowwise() - mean.transpose())).norm() < 1e-12);
    CHECK((slope_of(c, kSetting, amplitude) * amplitude - effect_of(c, kSetting, amplitude)).norm() < 1e-12);
    CHECK(bend_of(c, kSetting, amplitude).norm() == 0.0);
  }
  CHECK(effect_of(c, kSetting, 0.0).norm() == 0.0);
}

TEST_CASE("between its two sides a setting's bend is the parabola's through its runs") {
  const Setting setting;
  const Comparison c = compare(setting.evidence(0.0, 3), TestUse::fit);
  const VectorXd up = effect_of(c, kSetting, kStep), down = effect_of(c, kSetting, -kStep);
  for (const double a : {-0.5, -0.2, 0.1, 0.4}) {
    const VectorXd parabola = 0.5 * (up - down) * (a / kStep) + 0.5 * (up + down) * (a * a / (kStep * kStep));
    CHECK((parabola - effect_of(c, kSetting, a) - bend_of(c, kSetting, a)).norm() < 1e-9);
  }
}

TEST_CASE("a setting that is off the other way is judged by runs of that side") {
  const Setting setting;
  double both = 0.0, one = 0.0;
  int kept = 0, kept_by_one = 0;
  constexpr int kDraws = 10;
  for (int draw = 0; draw < kDraws; ++draw) {
    const Said with = said(setting.evidence(-1.0, static_cast<std::uint64_t>(draw)));
    const Said without = said(setting.evidence(-1.0, static_cast<std::uint64_t>(draw), true));
    CHECK(with.explained > 4.0 * without.explained);
    CHECK((with.shown - with.down).norm() < 1e-9);
    CHECK((without.shown - without.up).norm() < 1e-9);
    kept += with.kept;
    kept_by_one += without.kept;
    both += with.amplitude / kDraws;
    one += without.amplitude / kDraws;
  }
  CHECK(both == Approx(-1.0).margin(0.06));
  CHECK(std::abs(one) < 0.5);
  CHECK(kept >= kDraws - 1);
  CHECK(kept_by_one <= 1);
}

TEST_CASE("runs of one side say nothing for the other") {
  const Setting setting;
  for (const bool one_side : {false, true}) {
    Evidence evidence = setting.evidence(0.0, 5, one_side);
    for (std::size_t t = 0; t < evidence.tests.size(); ++t) {
      const Index first = static_cast<Index>(t) * setting.world.features;
      evidence.tests[t].measured.rowwise() -= setting.above.segment(first, setting.world.features).transpose();
    }
    const Said mirrored = said(evidence);  // what the first side's runs do, with the other sign
    CHECK(mirrored.kept == one_side);
    CHECK((mirrored.explained > 17.0) == one_side);
  }
}
