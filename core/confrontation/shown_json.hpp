#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/confrontation/feature_source.hpp"
#include "core/confrontation/shown_runs.hpp"

namespace asperity {

/// shown.json: what a report needs beside verdict.json, so that it can be made anew from the folder alone: what was
/// declared, measured and simulated curves, residuals and fingerprints in standard deviations without what calibration
/// absorbs (Eq. (N11)), and what the runs cost. Reads the finished runs' folders; throws what reading them throws.
nlohmann::ordered_json shown_json(const ConfrontationConfig& config, const Confrontation& confrontation,
                                  const std::vector<ShownRuns>& shown, const FeatureCost& cost);

}  // namespace asperity
