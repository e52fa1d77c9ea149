#include "core/experiment/loading.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/units.hpp"
#include "core/contact/closed_forms.hpp"
#include "core/experiment/drive_train.hpp"

namespace asperity {
namespace {

/// Adds the linear field that joins the two platens' velocities, Eq. (E1), and books its kinetic energy as work. Behind
/// a drive line the platens take part in the drive's rate as the specimen does in the compliance.
void add_linear_velocity_field(Model& model, double rate) {
  Particles& p = model.system.particles;
  const double height = specimen_length(model.config);
  set_closing_rate(model.system, rate);
  rate *= specimen_share(model);
  for (std::size_t i = 0; i < p.node_count(); ++i) {
    const Vec2 before = p.velocity[i];
    p.velocity[i].y += rate * (0.5 - p.reference(i).y / height);
    model.system.initial_kinetic += 0.5 * p.mass[i] * (dot(p.velocity[i], p.velocity[i]) - dot(before, before));
  }
  model.system.platens.velocity = {0.5 * rate, -0.5 * rate};
  model.system.platens.last_velocity = model.system.platens.velocity;
}

void set_moving(Model& model, LoadingState& state) {
  state.phase = LoadingPhase::moving;
  state.phase_start_s = model.system.time;
  if (is_compression(model.config.experiment.type) && model.config.experiment.loading.mode == LoadingMode::continuous) {
    add_linear_velocity_field(model, model.config.experiment.loading.closing_rate_mm_per_s);
  }
}

/// From the zero of strains on: by static equilibria first where the configuration says so.
void start_moving(Model& model, LoadingState& state) {
  state.zero_distance_mm = model.system.platens.y[1] - model.system.platens.y[0];
  state.zero_gauges = read_gauges(model.gauges, model.system.particles);
  state.rate_control.rate = model.config.experiment.loading.closing_rate_mm_per_s;
  tie_drive(model.system);
  if (model.config.experiment.loading.elastic_start_fraction > 0.0) {
    state.phase = LoadingPhase::elastic_start;
  } else {
    set_moving(model, state);
  }
}

/// Hydrostatic stage: pressure ramps up and the platens follow so that the axial stress equals it, Eq. (E2).
void confine(Model& model, LoadingState& state, double kinetic_ratio) {
  const ExperimentConfig& e = model.config.experiment;
  System& system = model.system;
  const double elapsed = system.time - state.phase_start_s;
  const double target = e.confining_pressure_mpa * std::min(1.0, elapsed / e.loading.confinement_time_s);
  const double present = 0.5 * (system.sums.reaction[0] + system.sums.reaction[1]) / e.width_mm;
  const bool settled = kinetic_ratio < e.loading.hold_kinetic_ratio && std::abs(present - target) < 1e-3 * target;
  if ((elapsed > e.loading.confinement_time_s && settled) || elapsed > 4.0 * e.loading.confinement_time_s) {
    set_closing_rate(system, 0.0);
    start_moving(model, state);
    return;
  }
  system.flank.pressure = target;
  const double modulus = closed_forms::effective_modulus(model.config.particles.youngs_modulus_gpa * units::kMpaPerGpa,
                                                         model.config.particles.poissons_ratio, e.plane);
  const double response_time = 0.1 * e.loading.confinement_time_s;
  set_closing_rate(system, e.height_mm / modulus * (target - present) / response_time);
}

/// Of the test's normal stress on all strips, N per mm of thickness.
double normal_load(const Model& model) {
  return model.config.experiment.normal_stress_mpa * (model.joint.gauge.strips.count * model.joint.profile.length());
}

/// First stage of direct shear, Eq. (E10): the normal load ramps up and is kept until the joint is at rest under it.
void press(Model& model, LoadingState& state, double kinetic_ratio) {
  const ExperimentConfig& e = model.config.experiment;
  RigidBlock& upper = model.system.blocks[kUpperBlock];
  const double elapsed = model.system.time - state.phase_start_s;
  const double full = normal_load(model);
  upper.load = -full * std::min(1.0, elapsed / e.loading.confinement_time_s);
  const bool settled = kinetic_ratio < e.loading.hold_kinetic_ratio && std::abs(upper.reaction.y - full) < 1e-3 * full;
  if ((elapsed > e.loading.confinement_time_s && settled) || elapsed > 4.0 * e.loading.confinement_time_s) {
    state.phase = LoadingPhase::moving;
    state.phase_start_s = model.system.time;
    state.zero_dilation = read_dilation(model.joint.gauge, model.system);
    tie_drive(model.system);
  }
}

/// The load on the upper block after the first stage, Eq. (E23).
void follow_dilation(Model& model, const LoadingState& state) {
  const double stiffness = normal_spring(model.config, model.joint);
  if (stiffness == 0.0) return;
  RigidBlock& upper = model.system.blocks[kUpperBlock];
  upper.load = -(normal_load(model) + stiffness * (upper.displacement.y - state.zero_dilation.mean));
}

/// The lower half at the shear rate, Eq. (E11).
void shear(Model& model, LoadingState& state) {
  const LoadingConfig& loading = model.config.experiment.loading;
  const double elapsed = model.system.time - state.phase_start_s;
  const double ramp = loading.ramp_time_s > 0.0 ? std::min(1.0, elapsed / loading.ramp_time_s) : 1.0;
  const double factor = unloading_factor(model, state.unloading, closure(model, state));
  set_shear_rate(model.system, factor * ramp * loading.shear_rate_mm_per_s);
  follow_dilation(model, state);
}

void move(Model& model, LoadingState& state) {
  const LoadingConfig& loading = model.config.experiment.loading;
  const double moved = closure(model, state) - state.phase_start_closure_mm;
  if (loading.mode == LoadingMode::staged && moved >= loading.stage_displacement_mm) {
    set_closing_rate(model.system, 0.0);
    state.phase = LoadingPhase::holding;
    state.phase_start_s = model.system.time;
    return;
  }
  const double elapsed = model.system.time - state.phase_start_s;
  const bool from_rest = loading.mode == LoadingMode::continuous && state.elastic_start.increments == 0;
  const double ramp = from_rest && loading.ramp_time_s > 0.0 ? std::min(1.0, elapsed / loading.ramp_time_s) : 1.0;
  const double rate =
      loading.rate_control.enabled ? advance_rate(model, state.rate_control) : loading.closing_rate_mm_per_s;
  set_closing_rate(model.system, unloading_factor(model, state.unloading, closure(model, state)) * ramp * rate);
}

void hold(Model& model, LoadingState& state, double kinetic_ratio) {
  const LoadingConfig& loading = model.config.experiment.loading;
  const double elapsed = model.system.time - state.phase_start_s;
  if (kinetic_ratio >= loading.hold_kinetic_ratio && elapsed < loading.hold_time_s) return;
  ++state.stages;
  state.phase = LoadingPhase::moving;
  state.phase_start_s = model.system.time;
  state.phase_start_closure_mm = closure(model, state);
}

}  // namespace

double closure(const Model& model, const LoadingState& state) {
  if (is_tied(model.system)) return drive_displacement(model.system);
  if (model.config.experiment.type == ExperimentType::direct_shear) {
    return model.system.blocks[kLowerBlock].displacement.x;
  }
  return state.zero_distance_mm - (model.system.platens.y[1] - model.system.platens.y[0]);
}

LoadingState start_loading(Model& model) {
  LoadingState state;
  state.zero_distance_mm = model.system.platens.y[1] - model.system.platens.y[0];
  const bool sheared = model.config.experiment.type == ExperimentType::direct_shear;
  if (sheared || model.config.experiment.confining_pressure_mpa > 0.0) {
    state.phase = LoadingPhase::confining;
  } else {
    start_moving(model, state);
  }
  return state;
}

void start_elastically(Model& model, LoadingState& state, const ParallelLoops& loops,
                       const std::function<bool()>& on_equilibrium) {
  state.elastic_start = solve_elastic_start(model, loops, on_equilibrium);
  state.elastic_start_closure_mm = closure(model, state);
  if (state.elastic_start.increments == 0) return set_moving(model, state);
  state.phase = LoadingPhase::moving;
  state.phase_start_s = model.system.time;
}

void drive(Model& model, LoadingState& state, double kinetic_ratio) {
  if (model.config.experiment.type == ExperimentType::direct_shear) {
    return state.phase == LoadingPhase::confining ? press(model, state, kinetic_ratio) : shear(model, state);
  }
  switch (state.phase) {
    case LoadingPhase::confining:
      return confine(model, state, kinetic_ratio);
    case LoadingPhase::moving:
      return move(model, state);
    case LoadingPhase::holding:
      return hold(model, state, kinetic_ratio);
    case LoadingPhase::elastic_start:
      return;
  }
}

}  // namespace asperity
