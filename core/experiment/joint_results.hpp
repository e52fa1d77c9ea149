#pragma once
#include <nlohmann/json.hpp>

#include "core/experiment/run.hpp"
#include "core/measurement/results.hpp"

namespace asperity {

/// Results of a direct shear test for summary.json: peak, residual, dilation, drops; Eqs. (E12)-(E14).
nlohmann::ordered_json joint_results(const Model& model, const RunState& state, const Peak& peak);

/// What became of each tooth: when it was sheared off, and what its flanks bore at the peak; Eq. (E15).
nlohmann::ordered_json tooth_entries(const Model& model, const RunState& state);

}  // namespace asperity
