#pragma once
#include <nlohmann/json.hpp>

#include "core/experiment/run.hpp"
#include "core/measurement/results.hpp"

namespace asperity {

/// The failure mode for summary.json: "at_half_peak", with the cracks broken when the load first fell to half its peak,
/// null where it did not; and "at_end".
nlohmann::ordered_json failure_entries(const Model& model, const RunState& state, const Peak& peak);

/// The first sample behind the peak whose stress beyond the confining pressure is at most half the peak's; Eq. (E9).
const Sample* half_peak_sample(const std::vector<Sample>& samples, const Peak& peak, double confining_pressure_mpa);

}  // namespace asperity
