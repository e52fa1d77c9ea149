#include "core/confrontation/confront.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "core/confrontation/extension_refit.hpp"
#include "core/confrontation/extension_runs.hpp"
#include "core/confrontation/verdict_json.hpp"
#include "tests/support/toy_laboratory.hpp"

using namespace asperity;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// How a toy's mechanisms act: by their amplitude; by more than that; or such that parameters lose their effect with
/// it.
enum class Toy { linear, curved, bent };

/// A simulator whose runs are numbers: four tests of eight features that are linear in two parameters and six
/// mechanisms, with a scatter that a mesh has in common between runs.
class ToySimulator {
 public:
  explicit ToySimulator(Toy kind = Toy::linear) : kind_(kind) {
    RandomStream random(11, "toy simulator");
    jacobian_ = 3.0 * toy::normals(kTests * kFeatures, kParameters, random);
    fingerprint_ = 4.0 * toy::normals(kTests * kFeatures, kMechanisms, random);
  }

  /// Samples of one specimen.
  VectorXd values(const VirtualSpecimen& s) const {
    RandomStream random(s.seed, "mesh of " + std::to_string(s.test));
    VectorXd v = jacobian_.middleRows(first(s.test), kFeatures) * s.coded;
    for (const MechanismAmplitude& m : s.mechanisms) {
      const double a = kind_ == Toy::curved ? m.amplitude * (1.0 + 0.5 * m.amplitude) : m.amplitude;
      if (kind_ == Toy::bent) v *= 1.0 / (1.0 + m.amplitude);
      v += a * fingerprint_.col(m.id.back() - '0').segment(first(s.test), kFeatures);
    }
    return v + toy::normals(kFeatures, 1, random).col(0);
  }

  RunConfig configure(const VirtualSpecimen& s) {
    specimens_.push_back(s);
    RunConfig config;
    config.particles.seed = specimens_.size() - 1;
    return config;
  }

  std::vector<RunFeatureValues> features(const std::vector<CampaignRun>& runs) {
    std::vector<RunFeatureValues> all;
    for (const CampaignRun& run : runs) {
      const VectorXd v = values(specimens_[run.config.particles.seed]);
      RunFeatureValues row(feature_kinds(ExperimentType::uniaxial).size());
      for (Index f = 0; f < v.size(); ++f) row[static_cast<std::size_t>(f)] = v(f);
      all.push_back(row);
    }
    runs_ += runs.size();
    return all;
  }

  std::size_t runs() const { return runs_; }

  static constexpr int kTests = 4, kFeatures = 8, kParameters = 2, kMechanisms = 6;

 private:
  static Index first(std::size_t test) { return static_cast<Index>(test) * kFeatures; }
  Toy kind_;
  Eigen::MatrixXd jacobian_, fingerprint_;
  std::vector<VirtualSpecimen> specimens_;
  std::size_t runs_ = 0;
};

/// Six specimens a test of a laboratory with these parameters and mechanisms; the last test is kept back.
ConfrontationTask task_of(ToySimulator& simulator, const VectorXd& truth, std::vector<MechanismAmplitude> hidden) {
  ConfrontationTask task;
  for (std::size_t t = 0; t < ToySimulator::kTests; ++t) {
    TestEvidence test;
    test.id = "T" + std::to_string(t);
    test.use = t + 1 == ToySimulator::kTests ? TestUse::hold_out : TestUse::fit;
    for (int f = 0; f < ToySimulator::kFeatures; ++f) test.slots.push_back({toy::kind(f), false, 0.01});
    test.instrument_sd = VectorXd::Zero(ToySimulator::kFeatures);
    test.measured.resize(6, ToySimulator::kFeatures);
    for (std::uint64_t s = 0; s < 6; ++s)
      test.measured.row(static_cast<Index>(s)) = simulator.values({t, truth, hidden, 9000 + s}).transpose();
    task.evidence.tests.push_back(std::move(test));
    task.plan.parameter_acts.emplace_back(ToySimulator::kParameters, true);
    task.plan.candidate_acts.emplace_back(ToySimulator::kMechanisms, true);
  }
  for (int p = 0; p < ToySimulator::kParameters; ++p)
    task.evidence.parameters.push_back({"p" + std::to_string(p), -8.0, 8.0});
  for (int k = 0; k < ToySimulator::kMechanisms; ++k)
    task.evidence.candidates.push_back({"m" + std::to_string(k), 0.6, false, false, 3.0});
  task.plan.candidate_meshes.assign(ToySimulator::kMechanisms, 8);
  task.options.draws.draws = 200;
  task.configure = [&](const VirtualSpecimen& s) { return simulator.configure(s); };
  task.features = [&](const std::string&, const std::vector<CampaignRun>& runs) { return simulator.features(runs); };
  return task;
}

VectorXd truth() { return (VectorXd(2) << 2.6, -1.7).finished(); }

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
  const auto refitted = std::find_if(c.conclusion.singles.begin(), c.conclusion.singles.end(), [&](const auto& fit) {
    return c.evidence.candidates[static_cast<std::size_t>(fit.causes.front())].id == "m1";
  });
  REQUIRE(refitted != c.conclusion.singles.end());
  CHECK(refitted->amplitude(0) == 0.0);
  CHECK(!refitted->kept);
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

TEST_CASE("a hypothesis by runs holds how far its runs scatter on all meshes") {
  ToySimulator simulator;
  const ConfrontationTask task = task_of(simulator, truth(), {{"m1", 0.9}});
  const Confrontation c = confront(task);
  const Hypothesis alike = hypotheses_by_runs(task, c, {{1}}).front();
  CHECK(alike.run_rows.rows() == static_cast<Index>(task.plan.noise));
  CHECK(alike.run_rows.cwiseAbs().maxCoeff() < 1e-9);  // a mesh's scatter is the same with and without the cause
  ConfrontationTask scattering = task;
  RandomStream random(7, "runs that scatter");
  scattering.features = [&](const std::string&, const std::vector<CampaignRun>& runs) {
    std::vector<RunFeatureValues> all = simulator.features(runs);
    for (RunFeatureValues& row : all) *row[2] += 0.5 * random.normal();
    return all;
  };
  const Hypothesis other = hypotheses_by_runs(scattering, c, {{1}}).front();
  CHECK(other.run_rows.col(2).norm() / std::sqrt(static_cast<double>(task.plan.noise) - 1.0) ==
        Approx(0.5).margin(0.25));
  CHECK(std::abs(other.run_rows.col(2).mean()) < 1e-9);
  CHECK(other.run_rows.col(3).norm() < 1e-9);
}

TEST_CASE("a cause whose runs end before a peak that the base's pass is told with them") {
  const int strength = 0, largest = 20;
  const auto confronted = [&](double amplitude_without_peak) {
    ToySimulator simulator;
    ConfrontationTask task = task_of(simulator, truth(), {{"m1", 0.9}});
    for (TestEvidence& test : task.evidence.tests) test.slots[strength].simulated = toy::kind(largest);
    std::set<std::uint64_t> ended;
    task.configure = [&](const VirtualSpecimen& s) {
      RunConfig run = simulator.configure(s);
      for (const MechanismAmplitude& m : s.mechanisms) {
        if (s.test == 1 && m.id == "m1" && m.amplitude > amplitude_without_peak) ended.insert(run.particles.seed);
      }
      return run;
    };
    task.features = [&](const std::string&, const std::vector<CampaignRun>& runs) {
      std::vector<RunFeatureValues> all = simulator.features(runs);
      for (std::size_t i = 0; i < runs.size(); ++i) {
        all[i][largest] = all[i][strength];
        if (ended.contains(runs[i].config.particles.seed)) all[i][strength].reset();
      }
      return all;
    };
    return confront(std::move(task));
  };
  const Confrontation c = confronted(0.7);
  REQUIRE(verdict_causes(c) == std::vector<std::string>{"m1"});
  REQUIRE(c.short_runs.size() == 1);
  const nlohmann::ordered_json told = verdict_json(c, {})["short_runs"][0];
  CHECK(told["causes"] == std::vector<std::string>{"m1"});
  CHECK(told["test"] == "T1");
  CHECK(told["feature"] == toy::kind(strength)->name);
  CHECK(told["base"] == 8);
  CHECK(told["extension"] == 0);
  CHECK(told["meshes"] == 8);
  CHECK(confronted(1.5).short_runs.empty());
}

TEST_CASE("of two causes that fit alike, the one whose runs lack a peak stands last") {
  const auto causes_with = [&](const std::string& ending) {
    ToySimulator simulator;
    ConfrontationTask task = task_of(simulator, truth(), {{"m1", 0.9}});
    std::set<std::uint64_t> ended;
    task.configure = [&](VirtualSpecimen s) {  // m4 does what m1 does
      const bool ends =
          std::any_of(s.mechanisms.begin(), s.mechanisms.end(), [&](const auto& m) { return m.id == ending; });
      for (MechanismAmplitude& m : s.mechanisms) m.id = m.id == "m4" ? "m1" : m.id;
      RunConfig run = simulator.configure(s);
      if (s.test == 1 && ends) ended.insert(run.particles.seed);
      return run;
    };
    for (TestEvidence& test : task.evidence.tests) test.slots[0].simulated = toy::kind(20);
    task.features = [&](const std::string&, const std::vector<CampaignRun>& runs) {
      std::vector<RunFeatureValues> all = simulator.features(runs);
      for (std::size_t i = 0; i < runs.size(); ++i) {
        all[i][20] = all[i][0];
        if (ended.contains(runs[i].config.particles.seed)) all[i][0].reset();
      }
      return all;
    };
    return verdict_causes(confront(std::move(task)));
  };
  CHECK(causes_with("m1") == std::vector<std::string>{"m4", "m1"});
  CHECK(causes_with("m4") == std::vector<std::string>{"m1", "m4"});
}

TEST_CASE("about the reference no further run is made for a refit") {
  ToySimulator simulator;
  ConfrontationTask task = task_of(simulator, truth(), {{"m2", 1.0}});
  task.linearised_at = LinearisedAt::reference;
  const Confrontation c = confront(std::move(task));
  CHECK(verdict_causes(c) == std::vector<std::string>{"m2"});
  const std::size_t a_test = 16 + 2 * 2 * 8 + 6 * 8;
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
  CHECK(c.evidence.tests.front().base.rows() == 16);
  CHECK(c.evidence.tests.back().base.rows() == 6);
  CHECK(c.evidence.tests.back().low[0].rows() == 6);
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
