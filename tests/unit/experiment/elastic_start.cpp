#include "core/experiment/elastic_start.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/experiment/softening.hpp"
#include "core/measurement/results.hpp"
#include "tests/unit/experiment/small_models.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

const ParallelLoops kLoops;

struct Run {
  Model model;
  RunState state;

  explicit Run(const RunConfig& config) : model(small_model(config)) {
    state = start_run(model);
    run_experiment(model, state, kLoops, {});
  }
  Peak peak() const { return find_peak(state.samples, 0.05); }
};

RunConfig with_start(ExperimentType type, double fraction) {
  RunConfig c = small_config(type);
  c.experiment.loading.closing_rate_mm_per_s = 80;
  c.experiment.loading.elastic_start_fraction = fraction;
  if (type == ExperimentType::triaxial) c.experiment.confining_pressure_mpa = 0.5;
  c.experiment.stop.axial_strain = 0.012;
  return c;
}

/// The row at or just past a closure.
const Sample& row_at(const RunState& state, double closure) {
  return *std::find_if(state.samples.begin(), state.samples.end(),
                       [&](const Sample& s) { return s.closure_mm >= closure; });
}

/// Stress at a closure, between rows.
double stress_at(const RunState& state, double closure) {
  const Sample& after = row_at(state, closure);
  const Sample& before = *(&after - 1);
  const double t = (closure - before.closure_mm) / (after.closure_mm - before.closure_mm);
  return before.stress_mpa + t * (after.stress_mpa - before.stress_mpa);
}

}  // namespace

TEST_CASE("an elastic start ends at its share of first softening, with nothing damaged") {
  const LawForm form = GENERATE(LawForm::damage_slip, LawForm::cohesive_frictional);
  for (ExperimentType type : {ExperimentType::uniaxial, ExperimentType::triaxial, ExperimentType::brazilian}) {
    RunConfig config = with_start(type, 0.3);
    config.contacts.law.form = form;
    Model model = small_model(config);
    RunState state = start_run(model);
    const Model* at = &model;
    double reached = 0.0;
    RunObserver observer;
    observer.on_sample = [&](const Sample&) { reached = largest_separation(at->system.contacts); };
    observer.interrupted = [&] { return state.loading.elastic_start.increments > 0; };
    run_experiment(model, state, kLoops, observer);
    CHECK(state.loading.phase == LoadingPhase::moving);
    CHECK(state.loading.elastic_start.separation == Approx(0.3).epsilon(0.011));
    CHECK(reached == Approx(0.3).epsilon(0.02));
    CHECK(state.loading.elastic_start_closure_mm > 0.0);
    CHECK(state.samples.back().contacts_softening == 0);
    CHECK(state.samples.size() > 10);
  }
}

TEST_CASE("the static path is that of slow loading, and its account closes") {
  const LawForm form = GENERATE(LawForm::damage_slip, LawForm::cohesive_frictional);
  for (ExperimentType type : {ExperimentType::uniaxial, ExperimentType::triaxial, ExperimentType::brazilian}) {
    RunConfig config = with_start(type, 0.3);
    config.contacts.law.form = form;
    config.experiment.stop.axial_strain = type == ExperimentType::brazilian ? 0.004 : 0.012;
    const Run direct(config);
    const double end = direct.state.loading.elastic_start_closure_mm;
    REQUIRE(end < direct.state.samples.back().closure_mm);
    for (const Sample& s : direct.state.samples) {
      if (s.energy.external_work > 0.0) CHECK(std::abs(s.energy.error()) < 2e-4 * s.energy.external_work);
    }
    config.experiment.loading.elastic_start_fraction = 0.0;
    config.experiment.loading.closing_rate_mm_per_s = 40;
    config.measurement.samples = 1000;  // a row's stress is the mean since the last row: late by half a row
    const Run stepped(config);
    for (double share : {0.4, 0.7, 1.0}) {
      CAPTURE(share, static_cast<int>(type));
      CHECK(stress_at(direct.state, share * end) == Approx(stress_at(stepped.state, share * end)).epsilon(0.01));
    }
    const double later = 0.5 * (end + direct.state.samples.back().closure_mm);
    CHECK(stress_at(direct.state, later) == Approx(stress_at(stepped.state, later)).epsilon(0.01));
  }
}

TEST_CASE("peak and modulus after an elastic start are those of slow loading, in fewer steps") {
  RunConfig config = with_start(ExperimentType::uniaxial, 0.6);
  config.experiment.stop.axial_strain = 0.035;
  config.experiment.stop.fraction_of_peak = 0.8;
  config.measurement.peak_strain_limit = 0.035;
  const Run direct(config);
  config.experiment.loading.elastic_start_fraction = 0.0;
  const Run stepped(config);
  CHECK(direct.peak().stress_mpa == Approx(stepped.peak().stress_mpa).epsilon(0.02));
  const auto e = fit_moduli(direct.state.samples, direct.peak(), direct.model.config);
  const auto e_stepped = fit_moduli(stepped.state.samples, stepped.peak(), stepped.model.config);
  REQUIRE((e && e_stepped));
  CHECK(e->youngs_modulus_gpa == Approx(e_stepped->youngs_modulus_gpa).epsilon(0.01));
  const auto saved =
      static_cast<std::int64_t>(direct.state.loading.elastic_start_closure_mm / 80 / direct.model.system.time_step);
  CHECK(saved > direct.model.system.step);  // most of the loading
  CHECK(direct.model.system.step + saved == Approx(static_cast<double>(stepped.model.system.step)).epsilon(0.05));
}

TEST_CASE("after the start the specimen moves with its platens and does not ring") {
  RunConfig config = with_start(ExperimentType::uniaxial, 0.3);
  const Run run(config);
  const double end = run.state.loading.elastic_start_closure_mm;
  for (const Sample& s : run.state.samples) {
    // The linear field's own energy is 1e-4 N mm; a jolt to 80 mm/s would add as much and swing.
    if (s.closure_mm > end) CHECK(s.energy.kinetic < 1e-4 * (s.energy.elastic + s.energy.recoverable));
  }
}
