#pragma once
#include <nlohmann/json.hpp>
#include <vector>

#include "core/experiment/run.hpp"
#include "core/measurement/acoustic.hpp"
#include "core/measurement/results.hpp"

namespace asperity {

/// Every crack of a run with its energy for the whole thickness (N mm), in the order of time.
std::vector<Crack> run_cracks(const Model& model);

/// "cracks" of summary.json: how many of each mode, their directions, fragments and their sizes, acoustic events with
/// the b-value of their magnitudes.
nlohmann::ordered_json crack_entries(const Model& model, const Sample& last);

/// Adds the stresses of crack initiation and crack damage (core/measurement README) to a compression test's results.
void add_crack_stresses(const Model& model, const RunState& state, const Peak& peak, nlohmann::ordered_json& results);

}  // namespace asperity
