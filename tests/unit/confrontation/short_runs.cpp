#include "core/confrontation/short_runs.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "core/confrontation/extension_refit.hpp"
#include "core/confrontation/verdict_json.hpp"
#include "tests/support/toy_simulator.hpp"

using namespace asperity;
using Eigen::Index;
using toy::task_of;
using toy::ToySimulator;
using toy::truth;

TEST_CASE("a hypothesis by runs holds how far its runs scatter on all meshes") {
  ToySimulator simulator;
  const ConfrontationTask task = task_of(simulator, truth(), {{"m1", 0.9}});
  const Confrontation c = confront(task);
  const Hypothesis alike = hypotheses_by_runs(task, c, {{1}}).front();
  CHECK(alike.run_rows.rows() == static_cast<Index>(task.plan.apart + task.plan.noise));
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
