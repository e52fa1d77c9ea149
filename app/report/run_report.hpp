#pragma once
#include <filesystem>
#include <string>

#include "core/config/run_config.hpp"

namespace asperity::app {

/// How an experiment is called on a page.
std::string experiment_title(ExperimentType type);

/// Whether the folder holds a run.
bool is_run_folder(const std::filesystem::path& folder);

/// Writes report.html from the run folder's files alone (summary.json, manifest.json, config.effective.json, the
/// tables, and the pictures and plots that are there), replacing an older one; returns the page's path. A run that did
/// not come to its end gets a page that says so. Errors: Error(config) where a file is not of its form, Error(output)
/// where the page cannot be written.
std::filesystem::path write_run_report(const std::filesystem::path& folder);

}  // namespace asperity::app
