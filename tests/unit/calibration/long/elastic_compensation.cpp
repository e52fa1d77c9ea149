#include "core/calibration/elastic_compensation.hpp"

#include <catch2/catch.hpp>

#include "core/experiment/run.hpp"
#include "core/measurement/results.hpp"

using namespace asperity;

namespace {

/// The paper's specimen with 2 mm edges, loaded to failure.
RunConfig plaster(PlaneCondition plane) {
  RunConfig c;
  c.experiment.type = ExperimentType::uniaxial;
  c.experiment.plane = plane;
  c.experiment.loading.closing_rate_mm_per_s = 80;
  c.experiment.stop.axial_strain = 0.02;
  c.experiment.stop.fraction_of_peak = 0.8;
  c.contacts.tensile_strength_mpa = 4;
  c.contacts.cohesion_mpa = 1.7;
  c.contacts.friction_angle_deg = 38;
  return c;
}

struct Outcome {
  double strength = 0;
  ElasticResult moduli;
};

Outcome run(const RunConfig& config) {
  const ParallelLoops loops;
  Model model = build_model(config, loops);
  RunState state = start_run(model);
  run_experiment(model, state, loops, {});
  const Peak peak = find_peak(state.samples, config.measurement.peak_strain_limit);
  return {peak.stress_mpa, fit_moduli(state.samples, peak, config).value()};
}

}  // namespace

TEST_CASE("the plaster's specimen, compensated, shows E and nu within 1 % in a run to failure") {
  constexpr double kStrength = 6.8;  // MPa, at which these strengths make it fail; the window is placed by it
  const std::vector<std::pair<PlaneCondition, double>> cases{{PlaneCondition::strain, 10.0},
                                                             {PlaneCondition::stress, 4.0}};
  for (const auto& [plane, multiple] : cases) {
    ElasticTask task;
    task.config = plaster(plane);
    task.target = {1.3, 0.2, kStrength};
    task.stiffness = {StiffnessRule::multiple, multiple};
    task.seeds = {1, 2};
    const ElasticCompensation found = compensate_elasticity(task);
    REQUIRE(found.reached);
    RunConfig config = with_elasticity(task.config, found.answer().particle, found.answer().contacts);
    double modulus = 0.0, ratio = 0.0;
    for (std::size_t i = 0; i < task.seeds.size(); ++i) {
      config.particles.seed = task.seeds[i];
      const Outcome outcome = run(config);
      CAPTURE(multiple, static_cast<int>(plane), task.seeds[i], outcome.strength, outcome.moduli.youngs_modulus_gpa,
              outcome.moduli.poissons_ratio);
      CHECK(outcome.strength == Approx(kStrength).epsilon(0.05));
      CHECK(outcome.moduli.youngs_modulus_gpa == Approx(found.specimens[i].youngs_modulus_gpa).epsilon(0.01));
      CHECK(outcome.moduli.poissons_ratio == Approx(found.specimens[i].poissons_ratio).epsilon(0.015));
      modulus += 0.5 * outcome.moduli.youngs_modulus_gpa;
      ratio += 0.5 * outcome.moduli.poissons_ratio;
    }
    CAPTURE(multiple, static_cast<int>(plane), modulus, ratio);
    CHECK(modulus == Approx(1.3).epsilon(0.01));
    CHECK(ratio == Approx(0.2).epsilon(0.01));
  }
}
