#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/confrontation/confront.hpp"
#include "core/confrontation/confrontation_config.hpp"
#include "core/confrontation/verdict_json.hpp"

namespace asperity {

/// The confrontation that a file asks for: evidence of the measured features, what acts where, how runs are made.
/// `features` answers for runs. Throws Error(config) as virtual tests do.
ConfrontationTask confrontation_task(const ConfrontationConfig& config, FeaturesOf features);

/// The library as candidates: amplitudes of their runs, suspects, ranges.
std::vector<Candidate> library_candidates(const std::vector<std::string>& ids);

/// Parameters' values at coded levels, all of the file's, calibrated or not.
std::vector<double> theta_at(const ConfrontationConfig& config, const Eigen::VectorXd& coded);

/// What is decided before measured values are compared: tests' split, virtual tests and features, the library with its
/// strong values, parameters, levels, meshes and draws. The bytes of frozen.json, whose sha256 the verdict states.
std::string frozen_record(const ConfrontationConfig& config, const ConfrontationTask& task);

/// What the verdict says of parameters, hashes and the split.
VerdictContext verdict_context(const ConfrontationConfig& config, const ConfrontationTask& task,
                               const Confrontation& confrontation);

/// What decides a verdict: the file with its overrides but for where runs are computed, the measured numbers, the
/// bases. A sha256 in hexadecimal digits.
std::string confrontation_hash(const ConfrontationConfig& config);

/// Writes the best extension (or, without one, the calibrated base) as one run configuration a test into
/// `folder`/configs, and returns the first one's path relative to `folder`. Throws Error(output).
std::string write_extended_configs(const ConfrontationConfig& config, const Confrontation& confrontation,
                                   const std::filesystem::path& folder);

}  // namespace asperity
