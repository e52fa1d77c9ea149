#pragma once
#include <cstring>
#include <vector>

#include "core/experiment/checkpoint.hpp"
#include "core/experiment/run.hpp"
#include "core/experiment/summarise.hpp"
#include "tests/unit/experiment/small_models.hpp"

/// What the tests of mechanisms at the specimen's boundary share.
namespace asperity::testing {

/// A run and where it ended.
struct BoundaryRun {
  Model model;
  RunState state;
  explicit BoundaryRun(const RunConfig& config) : model(small_model(config)), state(start_run(model)) {}
  BoundaryRun& go_on(const ParallelLoops& loops = ParallelLoops(), std::int64_t steps = -1) {
    RunObserver observer;
    observer.interrupted = [&] { return --steps == 0; };
    if (state.stop == StopReason::interrupted) state.stop = StopReason::running;
    run_experiment(model, state, loops, observer);
    return *this;
  }
  double energy_error() const { return relative_closure_error(state.samples.back().energy); }
};

inline BoundaryRun run_of(const RunConfig& config) { return std::move(BoundaryRun(config).go_on()); }

inline bool same_bits(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec2)) == 0;
}

inline bool same_bits(const BoundaryRun& a, const BoundaryRun& b) {
  const System &x = a.model.system, &y = b.model.system;
  bool rows = a.state.samples.size() == b.state.samples.size();
  for (std::size_t i = 0; rows && i < a.state.samples.size(); ++i) {
    const Sample &s = a.state.samples[i], &t = b.state.samples[i];
    rows = s.stress_mpa == t.stress_mpa && s.closure_mm == t.closure_mm &&
           s.energy.external_work == t.energy.external_work && s.energy.damping == t.energy.damping &&
           s.joint.dilation.front == t.joint.dilation.front && s.joint.teeth[0].leading == t.joint.teeth[0].leading;
  }
  return rows && x.step == y.step && same_bits(x.particles.position, y.particles.position) &&
         same_bits(x.particles.velocity, y.particles.velocity) && x.external_work == y.external_work;
}

/// Broken off after so many steps, written, read into a fresh model and run to its end, once with two threads.
inline bool resumes_to_the_same_bytes(const RunConfig& config, std::int64_t steps) {
  const std::string hash(32, 'b');
  const BoundaryRun whole = run_of(config);
  BoundaryRun part(config);
  part.go_on(ParallelLoops(), steps);
  if (part.state.stop != StopReason::interrupted || part.model.system.step >= whole.model.system.step) return false;
  BoundaryRun resumed(config);
  read_checkpoint_bytes(checkpoint_bytes(part.model, part.state, hash), "state.bin", resumed.model, resumed.state,
                        hash);
  resumed.go_on(ParallelLoops(2));
  return same_bits(whole, resumed);
}

/// A weak specimen between platens, so quickly loaded that it fails after some thousand steps.
inline RunConfig weak_column(ExperimentType type = ExperimentType::uniaxial) {
  RunConfig c = small_config(type);
  c.experiment.plane = PlaneCondition::stress;
  if (type == ExperimentType::triaxial) c.experiment.confining_pressure_mpa = 0.3;
  c.experiment.loading.closing_rate_mm_per_s = 300;
  c.experiment.stop.axial_strain = 0.016;
  c.contacts.tensile_strength_mpa = 2;
  c.contacts.cohesion_mpa = 1.2;
  return c;
}

/// Two coarse, weak teeth sheared fast; some seconds.
inline RunConfig small_joint() {
  RunConfig c;
  c.experiment.type = ExperimentType::direct_shear;
  c.experiment.normal_stress_mpa = 1;
  c.experiment.loading.shear_rate_mm_per_s = 1000;
  c.experiment.loading.ramp_time_s = 5e-4;
  c.experiment.loading.confinement_time_s = 5e-4;
  c.experiment.stop.shear_displacement_mm = 2;
  c.joint.profile = {{20, 2, 1.5}, {35, 2, 1.5}};
  c.joint.end_gap_mm = 1.5;
  c.joint.lower_height_mm = c.joint.upper_height_mm = 6;
  c.joint.damage_depth_lower_mm = c.joint.damage_depth_upper_mm = 1.5;
  c.joint.coarse_edge_mm = 2;
  c.particles.edge_mm = 0.8;
  c.contacts.tensile_stiffness_mpa_per_mm = 6500;
  c.contacts.shear_stiffness_mpa_per_mm = 1800;
  c.contacts.tensile_strength_mpa = 0.8;
  c.contacts.cohesion_mpa = 0.8;
  c.contacts.fracture_energy_n_per_mm = 0.01;
  c.contacts.general.outline.friction_angle_deg = 30;
  c.contacts.general.outline.shear_stiffness_mpa_per_mm = 20;
  c.integration.mass_scaling.uniform = true;
  c.measurement.samples = 150;
  return c;
}

/// Elastic halves of one tooth that slide on each other: two seconds.
inline RunConfig sliding_joint(double shear_mm) {
  RunConfig c = small_joint();
  c.joint.profile = {{20, 2, 2}};
  c.joint.end_gap_mm = 2;
  c.joint.breakable = false;
  c.material.youngs_modulus_gpa = 13;
  c.experiment.loading.shear_rate_mm_per_s = 300;
  c.experiment.loading.ramp_time_s = 1e-3;
  c.experiment.stop.shear_displacement_mm = shear_mm;
  c.particles.edge_mm = 1;
  return c;
}

}  // namespace asperity::testing
