#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/output/manifest.hpp"
#include "core/output/run_folder.hpp"

namespace asperity::app {

/// Makes the folder of a command's results and those above it; there already: as it is. Throws Error(output).
void make_folder(const std::filesystem::path& folder);

/// The same, with the configuration as it was given in config.original.json.
void make_folder_with_config(const std::filesystem::path& folder, const std::filesystem::path& config);

/// A study's results and what decides them.
struct StudyFolder {
  std::filesystem::path folder;
  std::string config_name, config_hash;
  std::vector<std::string> results;  ///< Files and folders that a replaced study leaves nothing of.
};

/// Makes the folder ready for a study, which may go on in it; the configuration as it was given in
/// config.original.json, and a manifest that says `running`. Throws Error(output) where results of another
/// configuration lie there and `existing` is keep.
Manifest begin_study(const StudyFolder& study, const std::filesystem::path& config, ExistingRun existing);

}  // namespace asperity::app
