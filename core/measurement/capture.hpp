#pragma once
#include "core/config/run_config.hpp"
#include "core/integrator/system.hpp"
#include "core/measurement/frame.hpp"
#include "core/measurement/sample.hpp"

namespace asperity {

/// The present state as a frame, with the curve measured so far.
Frame capture_frame(const System& system, const RunConfig& config, std::span<const Sample> samples, int index);

/// "brazilian", "uniaxial" or "triaxial".
const char* experiment_name(ExperimentType type);

}  // namespace asperity
