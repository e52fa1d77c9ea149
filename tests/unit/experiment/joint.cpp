#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/units.hpp"
#include "core/experiment/joint_results.hpp"
#include "core/experiment/run.hpp"
#include "core/experiment/summarise.hpp"

using namespace asperity;

namespace {

RunConfig joint_config(double angle_deg, double normal_stress_mpa) {
  RunConfig c;
  c.experiment.type = ExperimentType::direct_shear;
  c.experiment.plane = PlaneCondition::strain;
  c.experiment.normal_stress_mpa = normal_stress_mpa;
  c.experiment.loading.shear_rate_mm_per_s = 100;
  c.experiment.loading.ramp_time_s = 1e-3;
  c.experiment.loading.confinement_time_s = 1e-3;
  c.experiment.stop.shear_displacement_mm = 3.0;
  c.joint.profile = {{angle_deg, 3.0, 3.0}};
  c.joint.end_gap_mm = 3.0;
  c.joint.lower_height_mm = c.joint.upper_height_mm = 8.0;
  c.joint.damage_depth_lower_mm = c.joint.damage_depth_upper_mm = 2.0;
  c.joint.coarse_edge_mm = 2.0;
  c.joint.breakable = false;
  c.material.youngs_modulus_gpa = 13.0;  // the closed form's halves are rigid
  c.particles.edge_mm = 1.0;
  c.contacts.tensile_stiffness_mpa_per_mm = 6500.0;
  c.contacts.shear_stiffness_mpa_per_mm = 1800.0;
  c.contacts.general.outline.friction_angle_deg = 35.0;
  c.contacts.general.outline.shear_stiffness_mpa_per_mm = 10.0;
  c.integration.mass_scaling.uniform = true;
  c.measurement.samples = 150;
  return c;
}

/// Slope of the dilation over the displacement in the second half of the way, once the joint's springs are loaded.
double dilation_rate(const std::vector<Sample>& samples) {
  const Sample &middle = samples[samples.size() / 2], &end = samples.back();
  return (end.joint.dilation.mean - middle.joint.dilation.mean) / (end.closure_mm - middle.closure_mm);
}

RunState run_joint(Model& model) {
  RunState state = start_run(model);
  run_experiment(model, state, ParallelLoops(), {});
  return state;
}

}  // namespace

TEST_CASE("An unbreakable tooth slides up its flank at sigma_n tan(phi_j + i) and dilates by tan(i)") {
  for (const auto& [angle, normal] : {std::pair{15.0, 1.47}, std::pair{30.0, 0.39}, std::pair{30.0, 1.47}}) {
    Model model = build_model(joint_config(angle, normal), ParallelLoops());
    const RunState state = run_joint(model);
    const auto results = summarise(model, state).results;
    const double expected = normal * std::tan((35.0 + angle) * units::kRadPerDeg);
    const double rate = dilation_rate(state.samples), peak = results.at("peak_shear_stress_mpa");
    WARN(angle << " degrees, " << normal << " MPa: peak over sliding " << peak / expected << ", dilation rate over tan i "
               << rate / std::tan(angle * units::kRadPerDeg) << ", energy error "
               << relative_closure_error(state.samples.back().energy) << ", steps " << model.system.step);
    CHECK(peak == Approx(expected).epsilon(0.01));
    CHECK(rate == Approx(std::tan(angle * units::kRadPerDeg)).epsilon(0.02));
    CHECK(relative_closure_error(state.samples.back().energy) < 5e-3);
  }
}
