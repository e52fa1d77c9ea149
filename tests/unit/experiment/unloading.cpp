#include <catch2/catch.hpp>
#include <cmath>

#include "core/measurement/results.hpp"
#include "tests/unit/experiment/small_models.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

/// Far below cracks, at a rate at which waves are small.
RunConfig elastic(ExperimentType type) {
  RunConfig config = small_config(type);
  config.experiment.loading.closing_rate_mm_per_s = 80;
  if (type == ExperimentType::triaxial) config.experiment.confining_pressure_mpa = 0.5;
  config.contacts.tensile_strength_mpa = config.contacts.cohesion_mpa = 60;
  config.contacts.fracture_energy_n_per_mm = 20;
  config.experiment.stop.axial_strain = 0.005;
  config.measurement.samples = 400;
  return config;
}

RunState run_of(const RunConfig& config, Model& model) {
  model = small_model(config);
  RunState state = start_run(model);
  run_experiment(model, state, ParallelLoops(), {});
  return state;
}

/// Turning points of a series: its values where it changes direction.
std::vector<double> turns(const std::vector<Sample>& samples, double Sample::*value) {
  std::vector<double> found;
  for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
    const double before = samples[i].*value - samples[i - 1].*value, after = samples[i + 1].*value - samples[i].*value;
    if (before * after < 0.0) found.push_back(samples[i].*value);
  }
  return found;
}

}  // namespace

TEST_CASE("a test turns at the displacements asked for, unloads to the share asked for and goes on") {
  const ExperimentType type = GENERATE(ExperimentType::uniaxial, ExperimentType::triaxial, ExperimentType::brazilian);
  RunConfig config = elastic(type);
  const double length = specimen_length(config), base = config.experiment.confining_pressure_mpa;
  config.experiment.loading.unloading = {{0.0015 * length, 0.3}, {0.003 * length, 0.6}};
  Model model;
  const RunState state = run_of(config, model);
  CHECK(state.stop == StopReason::strain);
  const std::vector<double> closure = turns(state.samples, &Sample::closure_mm);
  REQUIRE(closure.size() == 4);
  CHECK(closure[0] == Approx(0.0015 * length).epsilon(0.1));  // it takes a turn's time to stop
  CHECK(closure[2] == Approx(0.003 * length).epsilon(0.05));
  std::vector<double> lowest(2, 1e9), highest(2, 0.0);
  for (std::size_t i = 0; i < 2; ++i) {
    for (const Sample& s : state.samples) {
      if (s.closure_mm == closure[2 * i]) highest[i] = s.stress_mpa - base;
      if (s.closure_mm == closure[2 * i + 1]) lowest[i] = s.stress_mpa - base;
    }
  }
  CHECK(lowest[0] / highest[0] == Approx(0.3).margin(0.05));
  CHECK(lowest[1] / highest[1] == Approx(0.6).margin(0.05));
  const EnergyBalance& energy = state.samples.back().energy;
  CHECK(std::abs(energy.error()) < 1e-3 * energy.external_work);
}

TEST_CASE("an elastic specimen reloads on the line it was unloaded on") {
  RunConfig config = elastic(ExperimentType::uniaxial);
  config.experiment.loading.unloading = {{0.003 * 65, 0.2}};
  Model model;
  const RunState state = run_of(config, model);
  double loading = 0.0, reloading = 0.0;  // at one strain, on the first way and on the last
  for (const Sample& s : state.samples) {
    if (std::abs(s.axial_strain - 0.002) > 2e-5) continue;
    if (loading == 0.0) loading = s.stress_mpa;
    reloading = s.stress_mpa;
  }
  REQUIRE(loading > 0.1);
  CHECK(reloading == Approx(loading).epsilon(0.03));
}

TEST_CASE("neither the stop fraction nor the moduli see a loop") {
  RunConfig config = elastic(ExperimentType::uniaxial);
  config.experiment.stop.fraction_of_peak = 0.9;
  config.contacts.tensile_strength_mpa = config.contacts.cohesion_mpa = 6;
  config.contacts.fracture_energy_n_per_mm.reset();
  config.experiment.stop.axial_strain = 0.01;
  config.experiment.loading.unloading = {{0.004 * 65, 0.1}};
  Model model;
  const RunState state = run_of(config, model);
  const std::vector<double> closure = turns(state.samples, &Sample::closure_mm);
  REQUIRE(closure.size() == 2);
  CHECK(state.samples.back().closure_mm > closure[0]);
  RunConfig straight = config;
  straight.experiment.loading.unloading.clear();
  Model other;
  const RunState without = run_of(straight, other);
  const Peak peak = find_peak(state.samples, 0.01), plain = find_peak(without.samples, 0.01);
  const auto moduli = fit_moduli(state.samples, peak, config), expected = fit_moduli(without.samples, plain, straight);
  REQUIRE(moduli);
  REQUIRE(expected);
  CHECK(moduli->youngs_modulus_gpa == Approx(expected->youngs_modulus_gpa).epsilon(0.01));
}

TEST_CASE("the lower half of a joint is driven back and forth") {
  RunConfig config = small_config(ExperimentType::direct_shear);
  config.experiment.normal_stress_mpa = 0.5;
  config.joint.breakable = false;
  config.joint.damage_depth_lower_mm = config.joint.damage_depth_upper_mm = 3;
  config.particles.edge_mm = 1.5;
  config.particles.edge_deviation_mm = 0.15;
  config.experiment.loading.shear_rate_mm_per_s = 400;
  config.experiment.loading.ramp_time_s = 2e-4;
  config.experiment.stop.shear_displacement_mm = 1.0;
  config.experiment.loading.unloading = {{0.5, 0.1}};
  config.measurement.samples = 200;
  Model model;
  const RunState state = run_of(config, model);
  const std::vector<double> moved = turns(state.samples, &Sample::closure_mm);
  REQUIRE(moved.size() == 2);
  CHECK(moved[0] == Approx(0.5).epsilon(0.25));
  CHECK(moved[1] < moved[0]);
  CHECK(state.samples.back().closure_mm >= 1.0);
}
