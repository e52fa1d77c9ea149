#pragma once
#include <filesystem>

namespace asperity::app {

/// Whether a folder directly below this one holds a run or a calibration.
bool holds_results(const std::filesystem::path& folder);

/// Writes index.html of a folder whose subfolders hold runs: a row a run with picture, experiment, set-up, key results,
/// status and date, to sort and to filter, and links to what else lies there; returns the page's path. A run that
/// cannot be read has a row that says why. Throws Error(output).
std::filesystem::path write_runs_index(const std::filesystem::path& folder);

}  // namespace asperity::app
