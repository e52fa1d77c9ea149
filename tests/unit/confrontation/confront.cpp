#include "core/confrontation/confront.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "core/confrontation/extension_runs.hpp"
#include "core/confrontation/verdict_json.hpp"
#include "tests/support/toy_simulator.hpp"

using namespace asperity;
using Eigen::Index;
using Eigen::VectorXd;
using toy::task_of;
using toy::Toy;
using toy::ToySimulator;
using toy::truth;

namespace {

/// Of the single causes; nullptr where it was not refitted.
const HypothesisFit* refit_of(const Confrontation& c, const std::string& id) {
  for (const HypothesisFit& fit : c.conclusion.singles) {
    if (c.evidence.candidates[static_cast<std::size_t>(fit.causes.front())].id == id) return &fit;
  }
  return nullptr;
}

}  // namespace

TEST_CASE("a hidden cause is found by runs at calibrated parameters, and its gain on a kept-back test is claimed") {
  ToySimulator simulator(Toy::curved);
  const Confrontation c = confront(task_of(simulator, truth(), {{"m1", 0.9}}));
  REQUIRE(c.conclusion.status == VerdictStatus::named);
  CHECK(verdict_causes(c) == std::vector<std::string>{"m1"});
  CHECK(c.conclusion.kept.front().amplitude(0) == Approx(0.9).margin(0.15));
  CHECK((c.centre + c.conclusion.kept.front().coded - truth()).cwiseAbs().maxCoeff() < 0.4);
  CHECK(c.conclusion.kept.front().converged);
  REQUIRE(c.extensions.size() == 1);
  REQUIRE(c.extensions.front().gain.has_value());
  CHECK(c.extensions.front().gain->claimed());
  CHECK(c.extensions.front().gain->rms_after < 0.5 * c.extensions.front().gain->rms_before);
  REQUIRE(!c.decoys.empty());
  CHECK(c.decoys.front().gain->elpd_change < c.extensions.front().gain->elpd_change);
}

TEST_CASE("a refit whose runs do not follow its linear fit says that it did not converge") {
  ToySimulator simulator;
  ConfrontationTask task = task_of(simulator, truth(), {{"m1", 0.9}});
  RandomStream random(5, "runs that follow nothing");
  task.features = [&](const std::string& stage, const std::vector<CampaignRun>& runs) {
    std::vector<RunFeatureValues> all = simulator.features(runs);
    if (!stage.starts_with("extension")) return all;
    const VectorXd shift = 30.0 * toy::normals(ToySimulator::kFeatures, 1, random).col(0);
    for (RunFeatureValues& row : all)
      for (Index f = 0; f < shift.size(); ++f) *row[static_cast<std::size_t>(f)] += shift(f);
    return all;
  };
  const Confrontation c = confront(std::move(task));
  REQUIRE(!c.conclusion.singles.empty());
  for (const HypothesisFit& fit : c.conclusion.singles) CHECK(!fit.converged);
}

TEST_CASE(
    "a refit keeps only what its own runs show: where they get worse it stays at the base, unlike its linear fit") {
  ToySimulator simulator;
  ConfrontationTask task = task_of(simulator, truth(), {{"m1", 0.9}});
  std::set<std::uint64_t> extended;
  task.configure = [&](const VirtualSpecimen& s) {
    RunConfig run = simulator.configure(s);
    if (!s.mechanisms.empty()) extended.insert(run.particles.seed);
    return run;
  };
  task.features = [&](const std::string& stage, const std::vector<CampaignRun>& runs) {
    std::vector<RunFeatureValues> all = simulator.features(runs);
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (!stage.starts_with("extension m1") || !extended.contains(runs[i].config.particles.seed)) continue;
      for (int f = 0; f < ToySimulator::kFeatures; ++f) *all[i][static_cast<std::size_t>(f)] += 40.0;
    }
    return all;
  };
  const Confrontation c = confront(std::move(task));
  const HypothesisFit* refitted = refit_of(c, "m1");
  REQUIRE(refitted);
  CHECK(refitted->amplitude(0) == 0.0);
  CHECK(!refitted->kept);
}

TEST_CASE("a point whose runs tell nothing is no fit, whatever its linear fit promises") {
  ToySimulator simulator;
  ConfrontationTask task = task_of(simulator, truth(), {{"m1", 0.9}});
  task.features = [&](const std::string& stage, const std::vector<CampaignRun>& runs) {
    std::vector<RunFeatureValues> all = simulator.features(runs);
    if (!stage.starts_with("extension m1")) return all;
    for (RunFeatureValues& row : all) std::fill(row.begin(), row.end(), std::nullopt);
    return all;
  };
  const Confrontation c = confront(std::move(task));
  const HypothesisFit* refitted = refit_of(c, "m1");
  REQUIRE(refitted);
  CHECK(refitted->amplitude(0) == 0.0);
  CHECK(!refitted->kept);
  CHECK(!refitted->converged);
}

TEST_CASE("a cause whose effect changes the parameters' is found far from the base, and reported where it was run") {
  ToySimulator simulator(Toy::bent);
  ConfrontationTask task = task_of(simulator, (VectorXd(2) << 5.5, -4.0).finished(), {{"m1", 1.1}});
  std::vector<VirtualSpecimen> extended;
  const ConfigureRun configure = task.configure;
  task.configure = [&](const VirtualSpecimen& s) {
    if (s.mechanisms.size() == 1 && s.mechanisms.front().id == "m1") extended.push_back(s);
    return configure(s);
  };
  const Confrontation c = confront(std::move(task));
  REQUIRE(!c.conclusion.kept.empty());
  const HypothesisFit& fit = c.conclusion.kept.front();
  CHECK(verdict_causes(c) == std::vector<std::string>{"m1"});
  CHECK(fit.converged);
  CHECK(fit.amplitude(0) == Approx(1.1).margin(0.2));
  CHECK((c.centre + fit.coded - (VectorXd(2) << 5.5, -4.0).finished()).cwiseAbs().maxCoeff() < 0.6);
  CHECK(std::any_of(extended.begin(), extended.end(), [&](const VirtualSpecimen& s) {
    return s.test == 0 && s.mechanisms.front().amplitude == fit.amplitude(0) && s.coded == c.centre + fit.coded;
  }));
  CHECK(c.extensions.front().gain->rms_after < 0.5 * c.extensions.front().gain->rms_before);
}

TEST_CASE("kept-back tests by runs: in a linear world mean and covariance are those of the linear effects") {
  ToySimulator simulator;
  ConfrontationTask task = task_of(simulator, truth(), {{"m1", 0.9}});
  task.linearised_at = LinearisedAt::reference;  // which simulates the kept-back tests' linear effects, too
  const Confrontation c = confront(task);
  REQUIRE(!c.conclusion.kept.empty());
  const HypothesisFit& fit = c.conclusion.kept.front();
  const FeaturePrediction runs = predict_by_runs(task, c, fit);
  const FeaturePrediction linear = predict_extension(c.kept_back, c.kept_back_scatter, fit);
  CHECK((runs.mean - linear.mean).cwiseAbs().maxCoeff() < 1e-9);
  CHECK((runs.covariance - linear.covariance).norm() < 1e-6 * linear.covariance.norm());
  CHECK((runs.covariance - c.kept_back_scatter.covariance).norm() > 0.01 * linear.covariance.norm());
}

TEST_CASE("about the reference no further run is made for a refit") {
  ToySimulator simulator;
  ConfrontationTask task = task_of(simulator, truth(), {{"m2", 1.0}});
  task.linearised_at = LinearisedAt::reference;
  const Confrontation c = confront(std::move(task));
  CHECK(verdict_causes(c) == std::vector<std::string>{"m2"});
  const std::size_t a_test = 16 + 8 + 2 * 2 * 8 + 6 * 8;
  CHECK(simulator.runs() == 4 * a_test);
}

TEST_CASE("a laboratory without an effect claims nothing") {
  ToySimulator simulator;
  const Confrontation c = confront(task_of(simulator, truth(), {}));
  CHECK(c.conclusion.status == VerdictStatus::nothing_found);
  CHECK(c.extensions.empty());
  CHECK((c.centre + c.base.coded - truth()).cwiseAbs().maxCoeff() < 0.4);
}

TEST_CASE("with nothing to calibrate, wrong parameters are seen but have no name") {
  ToySimulator simulator;
  ConfrontationTask task = task_of(simulator, truth(), {});
  task.evidence.parameters.clear();
  for (auto& acts : task.plan.parameter_acts) acts.clear();
  task.configure = [&](const VirtualSpecimen& s) {
    VirtualSpecimen at_reference = s;
    at_reference.coded = VectorXd::Zero(2);
    return simulator.configure(at_reference);
  };
  const Confrontation c = confront(std::move(task));
  CHECK(c.gate.discrepancy);
  CHECK(c.conclusion.status == VerdictStatus::unexplained);
}

TEST_CASE("the same data give the same verdict to the byte") {
  const auto verdict = [] {
    ToySimulator simulator;
    const Confrontation c = confront(task_of(simulator, truth(), {{"m0", 1.0}}));
    return verdict_json(c, {}).dump();
  };
  CHECK(verdict() == verdict());
}

TEST_CASE("two causes are found where both act") {
  ToySimulator simulator;
  const Confrontation c = confront(task_of(simulator, truth(), {{"m0", 1.0}, {"m2", 0.8}}));
  REQUIRE(c.conclusion.status == VerdictStatus::two_causes);
  std::vector<std::string> causes = verdict_causes(c);
  std::sort(causes.begin(), causes.end());
  CHECK(causes == std::vector<std::string>{"m0", "m2"});
}

TEST_CASE("a parameter at the end of its range is stepped to the other side alone") {
  ToySimulator simulator;
  ConfrontationTask task = task_of(simulator, truth(), {});
  task.linearised_at = LinearisedAt::reference;
  task.evidence.parameters[1].upper = 0.3;
  const Confrontation c = confront(std::move(task));
  CHECK(c.evidence.tests[0].high[1].rows() == 0);
  CHECK(c.evidence.tests[0].low[1].rows() == 8);
  CHECK(c.fitted.curvature.col(1).isZero());
  CHECK((c.centre + c.base.coded - truth()).cwiseAbs().maxCoeff() < 0.4);
}

TEST_CASE("an illegal run leaves its place empty, and slots of it are not compared") {
  ToySimulator simulator;
  ConfrontationTask task = task_of(simulator, truth(), {});
  task.linearised_at = LinearisedAt::reference;
  task.configure = [&](const VirtualSpecimen& s) {
    return s.test == 0 && s.coded(0) > 0.5 ? std::nullopt : std::optional(simulator.configure(s));
  };
  const Confrontation c = confront(std::move(task));
  CHECK(c.evidence.tests[0].high[0].array().isNaN().all());
  CHECK(c.fitted.tests.size() == 2);
  CHECK(c.fitted.dropped.size() == ToySimulator::kFeatures);
}

TEST_CASE("kept-back tests have meshes of their own number") {
  ToySimulator simulator;
  ConfrontationTask task = task_of(simulator, truth(), {});
  task.plan.fresh = 6;
  const Confrontation c = confront(std::move(task));
  CHECK(c.evidence.tests.front().base.rows() == 8 + 16);
  CHECK(c.evidence.tests.back().base.rows() == 6);  // by runs no effect is taken there
  CHECK(c.evidence.tests.back().low[0].rows() == 6);
  CHECK(c.fitted.tests.front().averaged == 8 + 16);
  CHECK(compare(c.evidence, TestUse::fit, BaseMean::apart).tests.front().averaged == 16);
}

TEST_CASE("a test that alone determines a parameter is not predicted without it") {
  ToySimulator simulator;
  ConfrontationTask task = task_of(simulator, truth(), {});
  for (std::size_t t = 1; t < ToySimulator::kTests; ++t) task.plan.parameter_acts[t][1] = false;
  const Confrontation c = confront(std::move(task));
  for (const FeatureResidual& r : c.residuals) {
    CHECK(std::isnan(r.simulated_left_out) == (r.test == "T0"));
    CHECK(std::isnan(r.z_left_out) == (r.test == "T0"));
  }
}

TEST_CASE("an amplitude becomes one that a run can have") {
  const Candidate stiff{"frame", 0.6, false, false, 3.0, 0.05, false}, strips{"strips", 1, false, true, 1, 0, true},
      rate{"rate", 0.6, true, true, 2.0};
  CHECK(amplitude_of_run(stiff, 0.02) == 0.0);
  CHECK(amplitude_of_run(stiff, -1.0) == 0.0);
  CHECK(amplitude_of_run(stiff, 0.4) == 0.4);
  CHECK(amplitude_of_run(strips, 0.7) == 1.0);
  CHECK(amplitude_of_run(strips, 0.2) == 0.0);
  CHECK(amplitude_of_run(rate, -5.0) == -2.0);
}

TEST_CASE("without a feature that both sides give there is one clear error") {
  ToySimulator simulator;
  ConfrontationTask task = task_of(simulator, truth(), {});
  for (TestEvidence& test : task.evidence.tests) test.measured.setConstant(std::nan(""));
  CHECK_THROWS_WITH(confront(std::move(task)), Catch::Contains("no feature of a fitted test can be compared"));
}
