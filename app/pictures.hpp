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

/// Removes the pictures in frames/. Throws Error(output).
void clear_pictures(const RunFolder& folder);

/// Numbers of the frames of which a picture of the configuration's fields is missing.
std::vector<int> frames_to_draw(const std::filesystem::path& root, const OutputConfig& output);

/// Draws the configuration's fields of these frames; false where a signal ended it.
bool draw_until_interrupted(const RunFolder& folder, const OutputConfig& output, const std::vector<int>& frames);

}  // namespace asperity::app
