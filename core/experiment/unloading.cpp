#include "core/experiment/unloading.hpp"

#include <algorithm>
#include <cmath>

#include "core/experiment/rate_control.hpp"

namespace asperity {
namespace {

constexpr double kTurnTransits = 4.0;  // from one direction to the other: no wave worth the name
constexpr double kSmoothing = 0.25;    // of the turn: the load that decides

double turn_time(const Model& model) {
  return std::max(model.config.experiment.loading.ramp_time_s, kTurnTransits * transit_time(model));
}

/// Beyond the confining pressure's share, N per mm of thickness.
double present_load(const Model& model) {
  const ExperimentConfig& e = model.config.experiment;
  const System& system = model.system;
  if (e.type == ExperimentType::direct_shear) return system.blocks[kUpperBlock].reaction.x;
  const double load = 0.5 * (system.sums.reaction[0] + system.sums.reaction[1]);
  return is_compression(e.type) ? load - system.flank.pressure * e.width_mm : load;
}

/// Load and trend behind two filters of one time constant.
void follow_load(UnloadingState& state, double present, double constant, double dt) {
  const double share = std::min(1.0, dt / constant), change = (present - state.load) / constant;
  state.trend += share * (change - state.trend);
  state.load += share * (present - state.load);
}

/// Where a load that changes steadily will be when the drive stands still: the filter's lag, and half of a turn at half
/// the rate.
double load_when_stopped(const UnloadingState& state, double turn_time) {
  return state.load + state.trend * (kSmoothing * turn_time + 0.25 * turn_time);
}

}  // namespace

double unloading_factor(const Model& model, UnloadingState& state, double displacement_mm) {
  const std::vector<UnloadingConfig>& loops = model.config.experiment.loading.unloading;
  if (loops.empty()) return 1.0;
  const double time = turn_time(model), dt = model.system.time_step;
  follow_load(state, present_load(model), kSmoothing * time, dt);
  if (state.back && load_when_stopped(state, time) <= loops[state.begun - 1].stress_ratio * state.turn_load) {
    state.back = 0;
  }
  const bool next = state.begun < static_cast<int>(loops.size());
  if (!state.back && next && displacement_mm >= loops[state.begun].at_mm) {
    ++state.begun;
    state.back = 1;
    state.turn_load = load_when_stopped(state, time);
    state.turn_mm = displacement_mm;
  }
  const double step = 2.0 * dt / time;
  state.direction += std::clamp((state.back ? -1.0 : 1.0) - state.direction, -step, step);
  return state.direction;
}

bool inside_loop(const UnloadingState& state, double displacement_mm) {
  return state.begun > 0 && (state.back || displacement_mm < state.turn_mm);
}

}  // namespace asperity
