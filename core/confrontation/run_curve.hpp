#pragma once
#include <filesystem>

#include "core/config/run_config.hpp"
#include "core/measurement/curve.hpp"
#include "core/output/csv.hpp"

namespace asperity {

/// The curve of a simulated run, from its curves.csv. Throws Error(config) where a column is missing.
Curve curve_of_run(const CsvData& table, const RunConfig& config);

/// How a run's own features are read: without noise, as summary.json has them.
CurveReading reading_of_run(const RunConfig& config);

/// A run of a folder: what was simulated, and its curve.
struct RunCurve {
  RunConfig config;
  Curve curve;
};

/// Reads config.effective.json, with what its mechanisms set, and curves.csv. Throws Error(config) where the folder
/// holds no run.
RunCurve read_run_curve(const std::filesystem::path& folder);

}  // namespace asperity
