#pragma once
#include <functional>

#include "core/experiment/run.hpp"

namespace asperity::testing {

/// Some two hundred particles: a step takes some 50 microseconds. Mean edges of 5 mm scatter by more than the default.
inline RunConfig small_config(ExperimentType type) {
  RunConfig c;
  c.name = "small";
  c.experiment.type = type;
  c.experiment.plane = type == ExperimentType::brazilian ? PlaneCondition::stress : PlaneCondition::strain;
  c.experiment.width_mm = 27;
  c.experiment.height_mm = 65;
  c.particles.edge_mm = 5;
  c.particles.edge_deviation_mm = 0.6;
  c.measurement.axial_gauge_mm = 30;
  c.measurement.samples = 100;
  c.output.frames = 4;
  return c;
}

/// A disc so weak and so quickly loaded that it has cracked after some 1500 steps.
inline RunConfig weak_disc() {
  RunConfig c = small_config(ExperimentType::brazilian);
  c.experiment.loading.closing_rate_mm_per_s = 1000;
  c.experiment.stop.axial_strain = 0.02;
  c.contacts.tensile_strength_mpa = 2;
  c.contacts.cohesion_mpa = 0.8;
  return c;
}

/// A weak specimen under pressure, loaded so far and so quickly that pieces slide, turn and come off.
inline RunConfig crushed_triaxial() {
  RunConfig c = small_config(ExperimentType::triaxial);
  c.experiment.confining_pressure_mpa = 0.3;
  c.experiment.loading.closing_rate_mm_per_s = 1500;
  c.experiment.stop.axial_strain = 0.06;
  c.contacts.tensile_strength_mpa = 2;
  c.contacts.cohesion_mpa = 1.2;
  c.contacts.friction_angle_deg = 25;
  c.contacts.fracture_energy_n_per_mm = 0.02;
  return c;
}

inline Model small_model(const RunConfig& config) { return build_model(config, ParallelLoops()); }

/// The steps of run_experiment() without samples, until `done`.
inline void step_until(Model& model, LoadingState& loading, const std::function<bool()>& done) {
  const ParallelLoops loops;
  double kinetic_ratio = 1.0;
  while (!done()) {
    compute_forces(model.system, loops);
    drive(model, loading, kinetic_ratio);
    update_velocities(model.system, loops);
    if (model.system.step % 100 == 0) {
      const EnergyBalance e = energy_balance(model.system, loops);
      if (e.elastic + e.recoverable > 0.0) kinetic_ratio = e.kinetic / (e.elastic + e.recoverable);
    }
    update_positions(model.system, loops);
  }
}

}  // namespace asperity::testing
