#pragma once
#include <filesystem>
#include <string>

#include "core/config/run_config.hpp"
#include "core/output/run_folder.hpp"

namespace asperity::app {

/// What a folder of this configuration holds of its measured curve.
struct MeasuredCopy {
  bool given = false;
  std::string text;  ///< Of the file.
};

/// The configuration's. Throws Error(config) where the file is not one of the experiment's.
MeasuredCopy measured_copy(const RunConfig& config);

/// Writes the configuration as written and in force, and the measured curve, which the folder then has as its own.
void write_configs(const RunFolder& folder, RunConfig config, const std::string& original,
                   const MeasuredCopy& measured);

/// Whether a finished run's folder has this measured curve under this name.
bool has_measured(const RunConfig& config, const std::filesystem::path& root, const MeasuredCopy& measured);

/// A measured curve may come, change or go without the run being made again: plots are, and the page where there is
/// one.
void renew_measured(const RunConfig& config, const std::string& original, const std::filesystem::path& root,
                    const MeasuredCopy& measured);

}  // namespace asperity::app
