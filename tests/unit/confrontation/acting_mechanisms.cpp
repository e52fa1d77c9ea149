#include <catch2/catch.hpp>
#include <cmath>

#include "core/confrontation/confront.hpp"
#include "core/confrontation/verdict_json.hpp"
#include "tests/support/toy_simulator.hpp"

using namespace asperity;
using Eigen::Index;
using toy::task_of;
using toy::ToySimulator;
using toy::truth;

namespace {

constexpr Index kHidden = 1, kIdle = 5;  // candidates: m1 acts in all tests but T1, m5 in none
constexpr std::size_t kWithout = 1;
constexpr double kFar = 1.2;

/// A laboratory with m1 in it, in whose test T1 it does not act.
ConfrontationTask partly_acting(ToySimulator& simulator) {
  ConfrontationTask task = task_of(simulator, truth(), {{"m1", 0.9}});
  TestEvidence& without = task.evidence.tests[kWithout];
  for (Index s = 0; s < without.measured.rows(); ++s)
    without.measured.row(s) =
        simulator.values({kWithout, truth(), {}, 9000 + static_cast<std::uint64_t>(s)}).transpose();
  task.plan.candidate_acts[kWithout][kHidden] = false;
  for (auto& acts : task.plan.candidate_acts) acts[kIdle] = false;
  return task;
}

bool acts(Index candidate, const ComparedTest& part) {
  return candidate != kIdle && (candidate != kHidden || part.test->id != "T1");
}

void check_effects(const Comparison& comparison) {
  for (const ComparedTest& part : comparison.tests) {
    const auto size = static_cast<Index>(part.columns.size());
    REQUIRE(size == ToySimulator::kFeatures);
    for (Index k = 0; k < ToySimulator::kMechanisms; ++k) {
      CAPTURE(part.test->id, k);
      for (const double amplitude : {-1.0, 0.3, 0.6, kFar, 2.0}) {
        const Eigen::ArrayXd effect = effect_of(comparison, k, amplitude).segment(part.first, size).array();
        CHECK((acts(k, part) ? (effect != 0.0).all() : (effect == 0.0).all()));
        if (acts(k, part)) continue;
        CHECK((slope_of(comparison, k, amplitude).segment(part.first, size).array() == 0.0).all());
        CHECK((effect_rows(comparison, k, amplitude).middleCols(part.first, size).array() == 0.0).all());
      }
    }
  }
}

}  // namespace

TEST_CASE("a mechanism that does not act in a test changes nothing there, exactly, and is not run there") {
  for (const LinearisedAt at : {LinearisedAt::calibrated, LinearisedAt::reference}) {
    ToySimulator simulator;
    ConfrontationTask task = partly_acting(simulator);
    task.linearised_at = at;
    task.plan.far = at == LinearisedAt::reference;
    for (Candidate& candidate : task.evidence.candidates) candidate.far = task.plan.far ? kFar : 0.0;
    std::size_t idle_runs = 0, hidden_runs = 0;
    task.configure = [&](const VirtualSpecimen& s) {
      for (const MechanismAmplitude& m : s.mechanisms) {
        idle_runs += m.id == "m5" || (m.id == "m1" && s.test == kWithout);
        hidden_runs += m.id == "m1" && s.test != kWithout;
      }
      return simulator.configure(s);
    };
    const Confrontation c = confront(std::move(task));
    CHECK(c.fitted.tests.size() == 3);
    check_effects(c.fitted);
    CHECK(idle_runs == 0);
    CHECK(hidden_runs > 0);
    CHECK(c.gate.pattern.explained(kIdle) == 0.0);
    CHECK(std::isinf(c.gate.detectable(kIdle)));
    CHECK(c.gate.hidden_share(kIdle) == 1.0);
    CHECK(verdict_causes(c) == std::vector<std::string>{"m1"});
  }
}
