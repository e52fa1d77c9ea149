#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.hpp"
#include "core/calibration/analysis.hpp"
#include "core/calibration/published.hpp"

/// A calibration from runs that somebody else made: a table of coded levels and responses.
namespace asperity {

struct DataCalibration {
  std::string name, description;
  std::vector<Target> targets;
  Design design;  ///< Coded levels as in the file; alpha is the farthest star point.
  Responses responses;
  std::vector<std::vector<double>> tabled;  ///< Real values as in the file, runs as rows; empty if it has none.
  AnalysisOptions options;
  std::optional<Published> published;
};

/// Reads a calibration config of kind "data" and its table. Throws Error(config) that lists every fault with its JSON
/// pointer, or file:line of the table.
DataCalibration read_data_calibration(const std::filesystem::path& path);

/// Sections shared with calibrations that simulate; `faults` collects what is wrong.
std::vector<Target> read_targets(const nlohmann::ordered_json& config, std::vector<Fault>& faults);
std::vector<Factor> read_factors(const nlohmann::ordered_json& config, std::vector<Fault>& faults);
AnalysisOptions read_analysis(const nlohmann::ordered_json& config, std::vector<Fault>& faults);

/// calibration.json of such a calibration.
nlohmann::ordered_json calibration_json(const DataCalibration& calibration, const Analysis& analysis);

}  // namespace asperity
