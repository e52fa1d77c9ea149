#pragma once
#include <filesystem>

namespace asperity::app {

/// Makes the folder of a command's results and those above it; there already: as it is. Throws Error(output).
void make_folder(const std::filesystem::path& folder);

/// The same, with the configuration as it was given in config.original.json.
void make_folder_with_config(const std::filesystem::path& folder, const std::filesystem::path& config);

}  // namespace asperity::app
