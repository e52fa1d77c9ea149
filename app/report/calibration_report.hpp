#pragma once
#include <filesystem>

namespace asperity::app {

/// Whether the folder holds a calibration's results.
bool is_calibration_folder(const std::filesystem::path& folder);

/// Writes report.html and plots/*.png, *.svg from the folder's calibration.json (and manifest.json, pictures/*.png,
/// audit.md where they are there), replacing older ones; returns the page's path. The page needs no script and no
/// network. Errors: Error(config) where calibration.json is missing or not of its form, Error(output) where a file
/// cannot be written.
std::filesystem::path write_calibration_report(const std::filesystem::path& folder);

}  // namespace asperity::app
