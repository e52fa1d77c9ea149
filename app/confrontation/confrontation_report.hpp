#pragma once
#include <filesystem>

namespace asperity::app {

/// Whether the folder holds a verdict.
bool is_confrontation_folder(const std::filesystem::path& folder);

/// Draws the plots and writes report.html and report.md of verdict.json and shown.json; returns the page. Throws
/// Error(config) where shown.json is missing or cannot be read, Error(output).
std::filesystem::path write_confrontation_report(const std::filesystem::path& folder);

}  // namespace asperity::app
