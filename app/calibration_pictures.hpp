#pragma once
#include <filesystem>

#include "core/calibration/simulated_procedure.hpp"

namespace asperity::app {

/// Draws the crack networks of the chosen parameters' and the trade-off's first mesh into `folder`/pictures, where the
/// runs kept frames, and then what draw_calibration(folder) does.
void draw_calibration(const std::filesystem::path& folder, const SimulatedResult& result);

/// Writes plots and report.html of the folder's calibration.json.
void draw_calibration(const std::filesystem::path& folder);

}  // namespace asperity::app
