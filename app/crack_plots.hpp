#pragma once
#include <filesystem>

#include "core/config/run_config.hpp"
#include "core/output/csv.hpp"
#include "core/output/run_folder.hpp"
#include "render/drawing.hpp"

/// The plots of what broke, drawn from a run's tables; each with a CSV of what it shows. A plot that has nothing to
/// show is not drawn.
namespace asperity::app {

/// Rose of cracks, event magnitudes, events over strain, volumetric strain and fragment sizes.
void draw_crack_plots(const RunFolder& folder, const RunConfig& config);

/// Number of events by magnitude with its b-value, and events over the test.
void draw_event_plots(const RunFolder& folder, const RunConfig& config, const CsvData& curves);

/// Stress, volumetric and crack volumetric strain of a compression test up to its peak.
void draw_volumetric_plot(const RunFolder& folder, const RunConfig& config, const CsvData& curves);

/// Writes plots/NAME.png, .svg and .csv.
void write_plot_files(const RunFolder& folder, const char* name, const render::Drawing& drawing,
                      const std::vector<std::string>& columns, const std::vector<std::vector<CsvCell>>& rows);

/// The row of a test's largest stress up to its peak_strain_limit, as Eq. M3 of core/measurement has it.
std::size_t peak_row(const CsvData& curves, const RunConfig& config);

}  // namespace asperity::app
