#pragma once
#include <nlohmann/json.hpp>
#include <optional>

#include "core/contact/joint_strength.hpp"
#include "core/experiment/run.hpp"
#include "core/measurement/results.hpp"

namespace asperity {

/// Results of a direct shear test for summary.json: peak, residual, dilation, drops; Eqs. (E12)-(E14).
nlohmann::ordered_json joint_results(const Model& model, const RunState& state, const Peak& peak);

/// The joint as the closed forms see it; empty where the material's cohesion and friction angle are not given.
std::optional<ToothedJoint> toothed_joint(const RunConfig& config, const JointProfile& profile);

/// Closed forms of the strength beside the simulated peak and residual, for summary.json.
nlohmann::ordered_json closed_form_entries(const Model& model, const RunState& state);

/// What became of each tooth: when it was sheared off, and what its flanks bore at the peak; and whether
/// the teeth failed together or one after the other; Eqs. (E15)-(E17).
nlohmann::ordered_json tooth_entries(const Model& model, const RunState& state);

}  // namespace asperity
