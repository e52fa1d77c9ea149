#include "core/experiment/run.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/unit/experiment/small_models.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

/// A run from its start to its end, and what it told its observer.
struct Recorded {
  Model model;
  RunState state;
  std::vector<Frame> frames;
  std::vector<double> fractions;
  std::size_t samples_told = 0;

  explicit Recorded(const RunConfig& config, std::function<bool()> interrupted = {}) : model(small_model(config)) {
    state = start_run(model);
    RunObserver observer;
    observer.on_sample = [&](const Sample&) { ++samples_told; };
    observer.on_frame = [&](const Frame& frame) { frames.push_back(frame); };
    observer.on_progress = [&](const RunProgress& p) { fractions.push_back(p.fraction); };
    observer.interrupted = std::move(interrupted);
    run_experiment(model, state, ParallelLoops(), observer);
  }
  const Sample& last() const { return state.samples.back(); }
};

}  // namespace

TEST_CASE("steps between samples bring about the rows asked for to the stop strain") {
  RunConfig config = small_config(ExperimentType::uniaxial);
  config.experiment.stop.axial_strain = 0.02;
  config.experiment.loading.closing_rate_mm_per_s = 130;
  config.measurement.samples = 100;
  config.integration.time_step_s = 4e-7;
  Model model = small_model(config);
  CHECK(steps_per_sample(model) == 250);  // 0.02 * 65 mm / 130 mm/s = 10 ms = 25,000 steps
  model.config.measurement.samples = 1000000;
  CHECK(steps_per_sample(model) == 1);
}

TEST_CASE("a run ends at the first sample at or past the stop strain") {
  RunConfig config = weak_disc();
  config.experiment.stop.axial_strain = 0.004;
  config.measurement.samples = 20;
  const Recorded run(config);
  CHECK(run.state.stop == StopReason::strain);
  CHECK(run.last().axial_strain >= 0.004);
  CHECK(run.state.samples[run.state.samples.size() - 2].axial_strain < 0.004);
  CHECK(run.last().closure_mm == run.last().axial_strain * 54.0);
  CHECK(run.samples_told == run.state.samples.size());
  CHECK(std::abs(static_cast<int>(run.state.samples.size()) - 21) <= 1);  // some 421 steps in intervals of whole steps
}

TEST_CASE("a run ends at the stop time") {
  RunConfig config = weak_disc();
  config.experiment.stop.time_s = 1e-4;
  const Recorded run(config);
  CHECK(run.state.stop == StopReason::time);
  CHECK(run.last().time_s >= 1e-4);
  CHECK(run.state.samples[run.state.samples.size() - 2].time_s < 1e-4);
}

TEST_CASE("a run ends after five samples below the stop fraction of the peak, once something is broken") {
  RunConfig config = weak_disc();
  config.experiment.stop.axial_strain = 0.1;
  config.experiment.stop.fraction_of_peak = 0.8;
  config.measurement.samples = 2000;
  const Recorded run(config);
  REQUIRE(run.state.stop == StopReason::fraction_of_peak);
  double peak = 0.0;
  for (const Sample& s : run.state.samples) peak = std::max(peak, s.stress_mpa);
  const std::size_t n = run.state.samples.size();
  for (std::size_t i = n - 5; i < n; ++i) {
    CHECK(run.state.samples[i].stress_mpa < 0.8 * peak);
    CHECK(run.state.samples[i].cracks_tension + run.state.samples[i].cracks_shear > 0);
  }
}

TEST_CASE("an interrupted run stops after the step and goes on where it was") {
  RunConfig config = weak_disc();
  config.experiment.stop.axial_strain = 0.002;
  const Recorded whole(config);
  int asked = 0;
  Recorded run(config, [&] { return ++asked == 77; });
  CHECK(run.state.stop == StopReason::interrupted);
  CHECK(run.model.system.step == 77);
  run.state.stop = StopReason::running;
  run_experiment(run.model, run.state, ParallelLoops(), {});
  CHECK(run.model.system.step == whole.model.system.step);
  CHECK(run.last().stress_mpa == whole.last().stress_mpa);
}

TEST_CASE("a state gone wrong is found within the guards' interval and never becomes a checkpoint") {
  RunConfig config = weak_disc();
  config.measurement.samples = 5;
  config.integration.guard_interval_steps = 10;
  const int checkpoint_step = GENERATE(55, 1000);
  Model model = small_model(config);
  RunState state = start_run(model);
  std::vector<std::int64_t> written;
  RunObserver observer;
  observer.interrupted = [&] {
    if (model.system.step == 53) model.system.particles.velocity[7].x = std::nan("");
    return false;
  };
  observer.checkpoint_due = [&] { return model.system.step == 40 || model.system.step >= checkpoint_step; };
  observer.write_checkpoint = [&] { written.push_back(model.system.step); };
  REQUIRE(steps_per_sample(model) > 60);
  CHECK_THROWS_WITH(run_experiment(model, state, ParallelLoops(), observer), Catch::Contains("not finite"));
  CHECK(model.system.step == std::min(checkpoint_step, 60));
  CHECK(written == std::vector<std::int64_t>{40});
}

TEST_CASE("an interruption with a state gone wrong is a failure, not a checkpoint") {
  Model model = small_model(weak_disc());
  RunState state = start_run(model);
  RunObserver observer;
  observer.interrupted = [&] {
    model.system.particles.position[7].x = std::nan("");
    return true;
  };
  CHECK_THROWS_WITH(run_experiment(model, state, ParallelLoops(), observer), Catch::Contains("not finite"));
}

TEST_CASE("frames are spread over the strain, the first at the start and the last at the end") {
  RunConfig config = weak_disc();
  config.experiment.stop.axial_strain = 0.004;
  config.output.frames = 5;
  const Recorded run(config);
  REQUIRE(run.frames.size() == 5);
  CHECK(run.frames.front().axial_strain == 0.0);
  CHECK(run.frames.back().axial_strain == run.last().axial_strain);
  for (int i = 0; i < 5; ++i) {
    CHECK(run.frames[i].index == i);
    // A frame comes with the first sample past its strain: a hundredth of the stop strain late at most.
    CHECK(run.frames[i].axial_strain == Approx(0.001 * i).margin(1.01 * 4e-5));
  }
}

TEST_CASE("of one frame the last is kept, and none are possible") {
  RunConfig config = weak_disc();
  config.experiment.stop.axial_strain = 0.002;
  config.output.frames = 1;
  const Recorded one(config);
  REQUIRE(one.frames.size() == 1);
  CHECK(one.frames.front().index == 0);
  CHECK(one.frames.front().axial_strain == one.last().axial_strain);
  config.output.frames = 0;
  CHECK(Recorded(config).frames.empty());
}

TEST_CASE("progress grows to the whole") {
  RunConfig config = weak_disc();
  config.experiment.stop.axial_strain = 0.002;
  const Recorded run(config);
  CHECK(std::is_sorted(run.fractions.begin(), run.fractions.end()));
  CHECK(run.fractions.back() >= 1.0);
}

TEST_CASE("samples account for the energy of the specimen's whole thickness") {
  RunConfig thin = weak_disc();
  thin.experiment.stop.axial_strain = 0.002;
  RunConfig thick = thin;
  thick.experiment.thickness_mm = 4.0;  // a power of two: exact
  const Recorded one(thin), four(thick);
  CHECK(four.last().energy.external_work == 4.0 * one.last().energy.external_work);
  CHECK(four.last().energy.elastic == 4.0 * one.last().energy.elastic);
  CHECK(four.last().reaction_top_n == 4.0 * one.last().reaction_top_n);
  CHECK(four.last().stress_mpa == one.last().stress_mpa);
}

TEST_CASE("a staged test samples once a stage") {
  RunConfig config = weak_disc();
  config.experiment.loading.mode = LoadingMode::staged;
  config.experiment.loading.closing_rate_mm_per_s = 400;
  config.experiment.loading.hold_time_s = 5e-5;
  config.experiment.stop.axial_strain = 0.1 / 54;
  const Recorded run(config);
  const double step = 400 * run.model.system.time_step;
  REQUIRE(run.state.samples.size() >= 4);
  for (std::size_t i = 1; i < run.state.samples.size(); ++i) {
    const double stage = run.state.samples[i].closure_mm - run.state.samples[i - 1].closure_mm;
    CHECK(stage >= 0.02 * (1 - 1e-9));
    CHECK(stage <= 0.02 + 2 * step);  // the closing ends with a whole step
  }
}

TEST_CASE("the first sample of a triaxial test stands at the end of the hydrostatic stage") {
  RunConfig config = small_config(ExperimentType::triaxial);
  config.experiment.confining_pressure_mpa = 0.5;
  config.experiment.stop.axial_strain = 0.0005;
  config.experiment.loading.closing_rate_mm_per_s = 400;
  const Recorded run(config);
  const Sample& first = run.state.samples.front();
  CHECK(first.closure_mm == 0.0);
  CHECK(first.gauge_axial_strain == 0.0);
  CHECK(first.confining_pressure_mpa == 0.5);
  CHECK(first.stress_mpa == Approx(0.5).epsilon(0.01));  // the hydrostatic stage's own bar
}
