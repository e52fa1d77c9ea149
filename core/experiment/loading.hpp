#pragma once
#include "core/experiment/elastic_start.hpp"
#include "core/experiment/model.hpp"
#include "core/experiment/rate_control.hpp"
#include "core/experiment/unloading.hpp"

namespace asperity {

/// Where a test stands in its loading program.
enum class LoadingPhase : int { confining, moving, holding, elastic_start };

/// Everything the loading program remembers; plain data, part of the checkpoint.
struct LoadingState {
  LoadingPhase phase = LoadingPhase::moving;
  double phase_start_s = 0;
  double phase_start_closure_mm = 0;
  double zero_distance_mm = 0;  ///< Platen distance at zero closure (start, or after the hydrostatic stage).
  GaugeReading zero_gauges;
  DilationReading zero_dilation;  ///< Direct shear: under the normal load alone.
  int stages = 0;                 ///< Staged: stages finished.
  RateControlState rate_control;
  UnloadingState unloading;
  ElasticStart elastic_start;
  double elastic_start_closure_mm = 0;  ///< Closed by the elastic start.
};

/// The state at the start of a test. A uniaxial test starts from a linear velocity field, booked as work.
LoadingState start_loading(Model& model);

/// Sets the platens' velocities and the flank pressure for the coming step; Eqs. (E1)-(E3). Call after compute_forces
/// and update_velocities of the present step; `kinetic_ratio` is the last known kinetic over elastic energy.
void drive(Model& model, LoadingState& state, double kinetic_ratio);

/// Makes the elastic start of a test in that phase, after which its platens move; `on_equilibrium` is called at each
/// equilibrium and says whether to go on. Throws a numerical error where there is none.
void start_elastically(Model& model, LoadingState& state, const ParallelLoops& loops,
                       const std::function<bool()>& on_equilibrium);

/// Approach of the platens since the zero, or the shear displacement, mm.
double closure(const Model& model, const LoadingState& state);

}  // namespace asperity
