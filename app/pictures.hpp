#pragma once
#include <string>
#include <vector>

#include "core/config/run_config.hpp"
#include "core/output/run_folder.hpp"

namespace asperity::app {

/// Draws frames/ from the run's VTU files. `fields` empty: those of the configuration; `frames` is "all", "last" or a
/// number.
void draw_frames(const RunFolder& folder, const OutputConfig& output, const std::vector<std::string>& fields,
                 const std::string& frames);

/// Draws plots/ from the run's tables: stress-strain, energy account, cracks; each as PNG and SVG.
void draw_plots(const RunFolder& folder, ExperimentType type);

}  // namespace asperity::app
