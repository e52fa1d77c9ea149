#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/experiment/loading.hpp"
#include "core/measurement/frame.hpp"
#include "core/measurement/sample.hpp"

namespace asperity {

/// How a run is going, for a progress line.
struct RunProgress {
  double fraction = 0;  ///< Of the longest the run can take.
  const Sample* sample = nullptr;
  std::int64_t step = 0;
};

/// What the outside does while a test runs; any member may be empty.
struct RunObserver {
  std::function<void(const Sample&)> on_sample;
  std::function<void(const Frame&)> on_frame;
  std::function<void(const RunProgress&)> on_progress;
  std::function<bool()> interrupted;
  std::function<bool()> checkpoint_due;    ///< Asked after every step.
  std::function<void()> write_checkpoint;  ///< Called between two steps, with a state that has passed the guards.
};

/// Why the loop ended.
enum class StopReason : int { running, strain, fraction_of_peak, time, shear_displacement, interrupted };

/// Wall time spent on a run in all its sessions, s.
struct RunCost {
  double compute_s = 0;
  double output_s = 0;
};

/// Progress of a test beyond the model's own state; plain data, part of the checkpoint.
struct RunState {
  LoadingState loading;
  std::vector<Sample> samples;
  NodeSums reaction_sum;  ///< Only `reaction`, summed since the last sample.
  std::int64_t steps_in_sample = 0;
  int stages_sampled = 0;
  int frames = 0;
  double next_frame_strain = 0;
  double kinetic_ratio = 1;
  int samples_below = 0;  ///< Consecutive samples below the stop fraction of the peak.
  StopReason stop = StopReason::running;
  RunCost cost;
};

/// The state of a test that has not begun.
RunState start_run(Model& model);

/// Runs a test until its stop rule or an interruption. Throws a numerical error from the guards, which look at
/// the state every `integration.guard_interval_steps`, at samples, before checkpoints and at the end.
void run_experiment(Model& model, RunState& state, const ParallelLoops& loops, const RunObserver& observer);

/// Steps between samples so that about `measurement.samples` rows reach the stop strain.
std::int64_t steps_per_sample(const Model& model);

}  // namespace asperity
