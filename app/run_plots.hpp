#pragma once
#include "core/config/run_config.hpp"
#include "core/output/run_folder.hpp"

namespace asperity::app {

/// Draws plots/ from the run's tables, a measured curve as points among them: stress-strain (of a joint: shear stress,
/// dilation, its teeth), energy account, cracks and what they tell; each as PNG and SVG.
void draw_plots(const RunFolder& folder, const RunConfig& config);

/// Draws plots/strip.png from the run's VTU files: its cracks at telling moments, side by side. Nothing where the run
/// has no frames.
void draw_strip(const RunFolder& folder, const RunConfig& config);

}  // namespace asperity::app
