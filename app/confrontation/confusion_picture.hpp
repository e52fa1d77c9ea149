#pragma once
#include <filesystem>
#include <optional>

namespace asperity::app {

/// Draws the confusion matrix of a JSON file ({"rows": [...], "columns": [...], "counts": [[...]]}) as .png or .svg,
/// by default beside it, and returns the picture's path. Throws Error(config) where the file is none, Error(usage) for
/// another ending, Error(output).
std::filesystem::path draw_confusion(const std::filesystem::path& json,
                                     const std::optional<std::filesystem::path>& picture);

}  // namespace asperity::app
