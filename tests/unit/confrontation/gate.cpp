#include "core/confrontation/gate.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

#include "core/confrontation/naming.hpp"
#include "tests/support/toy_laboratory.hpp"

using namespace asperity;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

struct Analysis {
  Evidence evidence;
  Comparison comparison;
  Scatter scatter;
  BaseFit fit;
  Gate gate;
};

Analysis analyse(Evidence evidence, int draws) {
  Analysis a;
  a.evidence = std::move(evidence);
  a.comparison = compare(a.evidence, TestUse::fit);
  a.scatter = scatter_of(a.comparison, {});
  a.fit = calibrate_base(a.comparison, a.scatter.covariance, a.evidence.parameters);
  GateOptions options;
  options.draws = draws;
  a.gate = gate(a.comparison, a.scatter, a.fit, a.evidence.candidates, options);
  return a;
}

NamingOptions naming_options(int draws) {
  NamingOptions options;
  options.draws.draws = draws;
  return options;
}

std::vector<HypothesisFit> judged(const Analysis& a, const NamingOptions& options) {
  std::vector<Hypothesis> hypotheses;
  for (const Index k : refit_candidates(a.gate, options))
    hypotheses.push_back(linear_hypothesis(a.comparison, a.fit, {k}));
  return judge(a.comparison, a.scatter, a.fit, a.evidence.candidates, hypotheses, options);
}

toy::Hidden hidden_cause(const toy::World& world, Index cause, double amplitude) {
  toy::Hidden hidden = toy::nothing(world);
  hidden.parameters = VectorXd::LinSpaced(world.parameters, -0.8, 0.9);
  if (cause >= 0) hidden.amplitudes(cause) = amplitude;
  return hidden;
}

}  // namespace

TEST_CASE("calibration finds hidden parameters within its own errors") {
  const toy::World world;
  const toy::Hidden hidden = hidden_cause(world, -1, 0);
  double squares = 0.0;
  for (std::uint64_t draw = 0; draw < 20; ++draw) {
    const Analysis a = analyse(toy::evidence(world, hidden, draw), 2);
    squares += ((a.fit.coded - hidden.parameters).array() / a.fit.error.array()).square().mean() / 20.0;
  }
  CHECK(squares > 0.4);
  CHECK(squares < 2.0);
}

TEST_CASE("laboratories without an effect raise few alarms, strong effects nearly always one") {
  const toy::World world;
  int alarms = 0, seen = 0, right = 0, wrong = 0;
  for (std::uint64_t draw = 0; draw < 300; ++draw)
    alarms += analyse(toy::evidence(world, hidden_cause(world, -1, 0), draw), 200).gate.discrepancy;
  for (std::uint64_t draw = 0; draw < 80; ++draw) {
    const Index cause = static_cast<Index>(draw) % world.candidates;
    const Analysis a = analyse(toy::evidence(world, hidden_cause(world, cause, 1.0), 100 + draw), 200);
    if (!a.gate.discrepancy) continue;
    ++seen;
    const std::vector<HypothesisFit> fits = judged(a, naming_options(200));
    const bool in_set = std::any_of(fits.begin(), fits.end(),
                                    [&](const HypothesisFit& f) { return f.kept && f.causes.front() == cause; });
    const auto kept = std::count_if(fits.begin(), fits.end(), [](const HypothesisFit& f) { return f.kept; });
    right += in_set;
    wrong += kept == 1 && !in_set;
  }
  INFO(alarms << " alarms of 300, " << seen << " seen of 80, " << right << " right, " << wrong << " wrong");
  CHECK(alarms <= 9);
  CHECK(seen >= 72);
  CHECK(right >= 0.9 * seen);
  CHECK(wrong <= 0.05 * seen);
}

TEST_CASE("specimens that scatter more than meshes do raise no alarm") {
  const toy::World world;
  toy::Hidden hidden = toy::nothing(world);
  hidden.scatter = 2.5;
  int alarms = 0;
  for (std::uint64_t draw = 0; draw < 30; ++draw)
    alarms += analyse(toy::evidence(world, hidden, draw), 200).gate.discrepancy;
  CHECK(alarms <= 2);
}

TEST_CASE("a cause and its twin are both kept") {
  const toy::World world;
  Evidence evidence = toy::evidence(world, hidden_cause(world, 2, 1.0), 7);
  evidence.candidates.push_back({"twin", 0.6});
  for (TestEvidence& test : evidence.tests) test.mechanism.push_back(test.mechanism[2]);
  const Analysis a = analyse(std::move(evidence), 200);
  REQUIRE(a.gate.discrepancy);
  for (const HypothesisFit& f : judged(a, naming_options(200)))
    CHECK(f.kept == (f.causes.front() == 2 || f.causes.front() == world.candidates));
  const WhitenedFrame frame(a.scatter.covariance, a.fit.jacobian);
  const Eigen::MatrixXd projected = projected_fingerprints(frame, a.fit.difference, a.comparison);
  CHECK(cosine(projected.col(2), projected.col(world.candidates)) == Approx(1.0));
}

TEST_CASE("knobs that do nothing explain nothing") {
  const toy::World world;
  Evidence evidence = toy::evidence(world, hidden_cause(world, 1, 1.0), 3);
  evidence.candidates.push_back({"nothing", 0.6});
  for (TestEvidence& test : evidence.tests) test.mechanism.push_back(test.base.topRows(world.common));
  const Analysis a = analyse(std::move(evidence), 100);
  CHECK(a.gate.pattern.explained(world.candidates) == 0.0);
  CHECK(std::isinf(a.gate.detectable(world.candidates)));
}

TEST_CASE("an effect outside the library refutes every single cause") {
  const toy::World world;
  RandomStream random(5, "outside");
  int refuted = 0;
  for (std::uint64_t draw = 0; draw < 8; ++draw) {
    toy::Hidden hidden = toy::nothing(world);
    hidden.outside = toy::normals(world.tests * world.features, 1, random).col(0);
    hidden.outside *= 12.0 / hidden.outside.norm();
    const Analysis a = analyse(toy::evidence(world, hidden, draw), 200);
    REQUIRE(a.gate.discrepancy);
    const std::vector<HypothesisFit> fits = judged(a, naming_options(200));
    refuted += std::none_of(fits.begin(), fits.end(), [](const HypothesisFit& f) { return f.kept; });
  }
  CHECK(refuted >= 7);
}

TEST_CASE("a parameter at its limit absorbs nothing more") {
  const toy::World world;
  toy::Hidden hidden = toy::nothing(world);
  hidden.parameters(1) = 6.0;
  Evidence evidence = toy::evidence(world, hidden, 1);
  for (CalibratedParameter& p : evidence.parameters) p.lower = -10.0, p.upper = 10.0;
  CHECK(!analyse(evidence, 200).gate.discrepancy);
  evidence.parameters[1].upper = 2.0;
  const Analysis a = analyse(std::move(evidence), 200);
  CHECK(a.fit.limited[1]);
  CHECK(a.fit.coded(1) == 2.0);
  CHECK(a.gate.discrepancy);
}

TEST_CASE("an extension keeps its parameters and amplitudes within what is believed") {
  const toy::World world;
  toy::Hidden hidden = hidden_cause(world, 2, 4.0);
  hidden.parameters(1) = 4.0;
  Evidence evidence = toy::evidence(world, hidden, 1);
  const auto fit_within = [&](double upper, double most) {
    evidence.parameters[1].upper = upper;
    evidence.candidates[2].most = most;
    const Analysis a = analyse(evidence, 2);
    const Hypothesis h = held_within(linear_hypothesis(a.comparison, a.fit, {2}), a.evidence.parameters,
                                     a.scatter.covariance, a.evidence.candidates);
    return fit_hypothesis(a.scatter.covariance, a.evidence.candidates, h);
  };
  const HypothesisFit free = fit_within(10.0, 10.0), held = fit_within(1.0, 10.0), weak = fit_within(10.0, 1.0);
  CHECK(free.amplitude(0) == Approx(4.0).margin(0.5));
  CHECK(free.coded(1) == Approx(4.0).margin(1.0));
  CHECK(held.coded(1) == Approx(1.0));
  CHECK(held.misfit > free.misfit + 10.0);
  CHECK(weak.amplitude(0) == Approx(1.0));
  CHECK(weak.misfit > free.misfit + 10.0);
}

TEST_CASE("a second cause is found where there is one, and seldom where there is none") {
  const toy::World world;
  int found = 0, false_ones = 0;
  for (std::uint64_t draw = 0; draw < 10; ++draw) {
    toy::Hidden hidden = hidden_cause(world, 0, 1.0);
    const auto second = [&](const toy::Hidden& h) {
      const Analysis a = analyse(toy::evidence(world, h, draw), 10);
      return second_cause(a.comparison, a.scatter, a.fit, a.evidence.candidates,
                          linear_hypothesis(a.comparison, a.fit, {0}), naming_options(200));
    };
    false_ones += second(hidden).p < 0.01;
    hidden.amplitudes(4) = 1.0;
    const SecondCause s = second(hidden);
    found += s.p < 0.01 && s.candidate == 4;
  }
  CHECK(found >= 9);
  CHECK(false_ones <= 1);
}

TEST_CASE("data that agree too well are told") {
  toy::World world;
  Evidence evidence = toy::evidence(world, toy::nothing(world), 1);
  for (TestEvidence& test : evidence.tests) test.measured = test.base.colwise().mean().replicate(world.specimens, 1);
  CHECK(analyse(std::move(evidence), 400).gate.p_too_good < 0.01);
}

TEST_CASE("ordinary data do not agree too well") {
  const toy::World world;
  int told = 0;
  for (std::uint64_t draw = 0; draw < 20; ++draw)
    told += analyse(toy::evidence(world, toy::nothing(world), draw), 200).gate.p_too_good < 0.01;
  CHECK(told <= 1);
}

TEST_CASE("the gamma law's tail is that of an exponential sample's law") {
  RandomStream random(3, "gamma");
  std::vector<double> sample;
  for (int i = 0; i < 20000; ++i) sample.push_back(-std::log(1.0 - random.uniform()));
  CHECK(gamma_tail(sample, 5.0) == Approx(std::exp(-5.0)).epsilon(0.15));
}

TEST_CASE("where calibration absorbs every feature, nothing is too good") {
  const toy::World world;
  Analysis a = analyse(toy::evidence(world, toy::nothing(world), 1), 200);
  CHECK(a.gate.left > 0);
  a.fit.absorbing = Eigen::MatrixXd::Identity(a.comparison.data.size(), a.comparison.data.size());
  GateOptions options;
  options.draws = 200;
  const Gate nothing_left = gate(a.comparison, a.scatter, a.fit, a.evidence.candidates, options);
  CHECK(nothing_left.left == 0);
  CHECK(nothing_left.p_too_good > 0.9);
}

TEST_CASE("draws end where the user wants to") {
  const toy::World world;
  const Analysis a = analyse(toy::evidence(world, hidden_cause(world, 0, 0.8), 1), 200);
  int draws = 0;
  NamingOptions options = naming_options(200);
  options.draws.at_each_draw = [&] {
    if (++draws == 3) throw std::runtime_error("ended");
  };
  CHECK_THROWS_WITH(gate(a.comparison, a.scatter, a.fit, a.evidence.candidates, options.draws), "ended");
  draws = 0;
  CHECK_THROWS_WITH(judged(a, options), "ended");
  CHECK(draws == 3);
}
