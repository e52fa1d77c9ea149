#include "core/experiment/run.hpp"

#include <algorithm>
#include <cmath>

#include "core/integrator/guards.hpp"
#include "core/measurement/capture.hpp"
#include "core/measurement/crack_network.hpp"
#include "core/measurement/results.hpp"

namespace asperity {
namespace {

constexpr std::int64_t kEnergyInterval = 100;  // steps between looks at the kinetic ratio while a stage is held
constexpr int kSamplesBelow = 5;               // one noisy sample must not end a test

bool staged(const Model& model) { return model.config.experiment.loading.mode == LoadingMode::staged; }

void count(const Model& model, Sample& s, const ParallelLoops& loops) {
  const CrackCounts cracks = count_cracks(model.system.contacts, loops);
  s.cracks_tension = cracks.tension;
  s.cracks_shear = cracks.shear;
  s.contacts_softening = cracks.softening;
}

/// Direct shear: the stresses are means over the sample's steps, and over the strips, of the forces on the upper block;
/// Eq. (E24).
void measure_shear(const Model& model, const RunState& state, Sample& s) {
  const int strips = model.joint.gauge.strips.count;
  const double length = model.joint.profile.length(), thickness = model.config.experiment.thickness_mm;
  const double steps = static_cast<double>(std::max<std::int64_t>(1, state.steps_in_sample));
  const Vec2 on_lower = (1.0 / steps / strips) * state.reaction_sum.on_blocks[kLowerBlock];
  const Vec2 on_upper = (1.0 / steps / strips) * state.reaction_sum.on_blocks[kUpperBlock];
  s.load_n_per_mm = on_upper.x;
  s.stress_mpa = on_upper.x / length;
  s.reaction_bottom_n = -on_lower.x * thickness;
  s.reaction_top_n = on_upper.x * thickness;
  s.joint = read_joint(model.joint.gauge, model.system);
  s.joint.normal_stress_mpa = on_upper.y / length;
  s.joint.dilation -= state.loading.zero_dilation;
}

Sample measure(const Model& model, const RunState& state, const ParallelLoops& loops) {
  const ExperimentConfig& e = model.config.experiment;
  const System& system = model.system;
  Sample s;
  s.time_s = system.time;
  s.closure_mm = closure(model, state.loading);
  s.axial_strain = s.closure_mm / specimen_length(model.config);
  s.energy = energy_balance(system, loops).times(strip_thickness(model.config));
  count(model, s, loops);
  if (e.type == ExperimentType::direct_shear) {
    measure_shear(model, state, s);
    return s;
  }
  const GaugeReading gauges = read_gauges(model.gauges, system.particles);
  s.gauge_axial_strain = gauges.axial - state.loading.zero_gauges.axial;
  s.lateral_strain = gauges.lateral - state.loading.zero_gauges.lateral;
  const double steps = static_cast<double>(std::max<std::int64_t>(1, state.steps_in_sample));
  // A stage's row is read at its equilibrium (the paper's Sect. 3.1.2), a continuous test's is a mean over its steps.
  const double bottom = staged(model) ? system.sums.reaction[0] : state.reaction_sum.reaction[0] / steps;
  const double top = staged(model) ? system.sums.reaction[1] : state.reaction_sum.reaction[1] / steps;
  s.load_n_per_mm = 0.5 * (bottom + top);
  s.reaction_bottom_n = bottom * e.thickness_mm;
  s.reaction_top_n = top * e.thickness_mm;
  s.stress_mpa = e.type == ExperimentType::brazilian ? splitting_stress(s.load_n_per_mm, e.diameter_mm)
                                                     : s.load_n_per_mm / e.width_mm;
  s.confining_pressure_mpa = system.flank.pressure;
  s.disc = read_disc_gauge(model.disc, system);
  return s;
}

/// Kinetic over elastic energy; 1 while nothing is stored yet.
double kinetic_ratio(const EnergyBalance& energy) {
  const double stored = energy.elastic + energy.recoverable;
  return stored > 0.0 ? energy.kinetic / stored : 1.0;
}

StopReason stop_reason(const Model& model, RunState& state) {
  const StopConfig& stop = model.config.experiment.stop;
  const Sample& last = state.samples.back();
  const bool sheared = model.config.experiment.type == ExperimentType::direct_shear;
  if (last.axial_strain >= stop_strain(model.config)) {
    return sheared ? StopReason::shear_displacement : StopReason::strain;
  }
  if (stop.time_s && last.time_s >= *stop.time_s) return StopReason::time;
  const bool virgin = !inside_loop(state.loading.unloading, last.closure_mm);
  if (stop.fraction_of_peak && virgin && last.cracks_tension + last.cracks_shear > 0) {
    double peak = 0.0;
    for (const Sample& s : state.samples) peak = std::max(peak, s.stress_mpa);
    state.samples_below = last.stress_mpa < *stop.fraction_of_peak * peak ? state.samples_below + 1 : 0;
    if (state.samples_below >= kSamplesBelow) return StopReason::fraction_of_peak;
  }
  return StopReason::running;
}

bool rate_controlled(const Model& model) { return model.config.experiment.loading.rate_control.enabled; }

/// Rows stand at equal closures, which a constant rate passes in equal numbers of steps.
bool sample_due(const Model& model, const RunState& state, std::int64_t interval) {
  if (state.loading.phase == LoadingPhase::confining) return false;
  if (state.samples.empty()) return true;
  if (staged(model)) return state.loading.stages > state.stages_sampled;
  if (!rate_controlled(model)) return state.steps_in_sample >= interval;
  const ExperimentConfig& e = model.config.experiment;
  const double spacing = e.stop.axial_strain * specimen_length(model.config) / model.config.measurement.samples;
  const double last = state.samples.back().closure_mm;
  return std::floor(closure(model, state.loading) / spacing) > std::floor(last / spacing);
}

void take_sample(Model& model, RunState& state, const ParallelLoops& loops, const RunObserver& observer) {
  check_all(model.system, loops);
  state.samples.push_back(measure(model, state, loops));
  const Sample& sample = state.samples.back();
  state.kinetic_ratio = kinetic_ratio(sample.energy);
  state.reaction_sum = {};
  state.steps_in_sample = 0;
  state.stages_sampled = state.loading.stages;
  state.stop = stop_reason(model, state);
  if (observer.on_sample) observer.on_sample(sample);
  if (observer.on_progress) {
    observer.on_progress({sample.axial_strain / stop_strain(model.config), &sample, model.system.step});
  }
}

Frame frame_of(const Model& model, const RunState& state) {
  Frame frame = capture_frame(model.system, model.config, state.samples, state.frames);
  if (model.config.experiment.type != ExperimentType::direct_shear) return frame;
  const JointProfile& profile = model.joint.profile;
  frame.joint = {profile.length(),
                 profile.highest() - profile.lowest(),
                 model.config.experiment.stop.shear_displacement_mm,
                 model.system.blocks[kLowerBlock].displacement.x,
                 state.samples.back().joint.dilation.mean,
                 model.system.blocks[kUpperBlock].displacement.y,
                 model.joint.gauge.strips.count,
                 model.joint.gauge.strips.pitch_mm};
  for (const std::uint8_t lower : model.joint.gauge.lower) frame.half.push_back(lower ? 0 : 1);
  return frame;
}

void take_frame(const Model& model, RunState& state, const RunObserver& observer) {
  if (observer.on_frame) observer.on_frame(frame_of(model, state));
  ++state.frames;
  const double interval = stop_strain(model.config) / std::max(1, model.config.output.frames - 1);
  while (state.next_frame_strain <= state.samples.back().axial_strain) state.next_frame_strain += interval;
}

/// The last sample has a frame, and so has the first unless one frame is all that is wanted.
bool frame_due(const Model& model, const RunState& state) {
  const int frames = model.config.output.frames;
  if (state.stop != StopReason::running) return frames > 0;
  return frames > 1 && state.samples.back().axial_strain >= state.next_frame_strain;
}

void sample_and_frame(Model& model, RunState& state, const ParallelLoops& loops, const RunObserver& observer) {
  take_sample(model, state, loops, observer);
  if (frame_due(model, state)) take_frame(model, state, observer);
}

/// What the loading must know of the energies of this step.
void watch(Model& model, RunState& state, const ParallelLoops& loops) {
  const bool moving = state.loading.phase == LoadingPhase::moving;
  const bool settling = staged(model) || state.loading.phase == LoadingPhase::confining;
  if (settling && model.system.step % kEnergyInterval == 0) {
    state.kinetic_ratio = kinetic_ratio(energy_balance(model.system, loops));
  }
  if (moving && rate_controlled(model) && model.system.step % kRateInterval == 0) {
    choose_growth(model, state.loading.rate_control, loops);
  }
}

/// The equilibria of an elastic start, each a row of its own.
void start_elastically(Model& model, RunState& state, const ParallelLoops& loops, const RunObserver& observer) {
  start_elastically(model, state.loading, loops, [&] {
    state.reaction_sum = {};
    state.reaction_sum.reaction = model.system.sums.reaction;
    state.steps_in_sample = 1;
    sample_and_frame(model, state, loops, observer);
    return state.stop == StopReason::running;
  });
}

/// Interruption, guards and checkpoint, in an order in which only a checked state is written.
void end_step(const Model& model, RunState& state, const ParallelLoops& loops, const RunObserver& observer) {
  if (state.stop == StopReason::running && observer.interrupted && observer.interrupted())
    state.stop = StopReason::interrupted;
  const bool saving = observer.checkpoint_due && observer.checkpoint_due();
  const bool guarded = model.system.step % model.config.integration.guard_interval_steps == 0;
  if (saving || guarded || state.stop != StopReason::running) check_all(model.system, loops);
  if (saving) observer.write_checkpoint();
}

}  // namespace

RunState start_run(Model& model) {
  RunState state;
  state.loading = start_loading(model);
  return state;
}

std::int64_t steps_per_sample(const Model& model) {
  const ExperimentConfig& e = model.config.experiment;
  const double rate =
      e.type == ExperimentType::direct_shear ? e.loading.shear_rate_mm_per_s : e.loading.closing_rate_mm_per_s;
  const double duration = stop_strain(model.config) * specimen_length(model.config) / rate;
  return std::max<std::int64_t>(1, std::llround(duration / model.system.time_step / model.config.measurement.samples));
}

void run_experiment(Model& model, RunState& state, const ParallelLoops& loops, const RunObserver& observer) {
  System& system = model.system;
  const std::int64_t interval = steps_per_sample(model);
  while (state.stop == StopReason::running) {
    if (state.loading.phase == LoadingPhase::elastic_start && !state.samples.empty()) {
      start_elastically(model, state, loops, observer);
      continue;
    }
    compute_forces(system, loops);
    drive(model, state.loading, state.kinetic_ratio);
    const bool confining = state.loading.phase == LoadingPhase::confining;
    update_velocities(system, loops);
    if (!confining) {  // the first sample shows the end of the hydrostatic stage
      ++state.steps_in_sample;
      for (int i = 0; i < 2; ++i) {
        state.reaction_sum.reaction[i] += system.sums.reaction[i];
        state.reaction_sum.on_blocks[i] += system.sums.on_blocks[i];
      }
    }
    watch(model, state, loops);
    if (sample_due(model, state, interval)) sample_and_frame(model, state, loops, observer);
    update_positions(system, loops);
    end_step(model, state, loops, observer);
  }
}

}  // namespace asperity
