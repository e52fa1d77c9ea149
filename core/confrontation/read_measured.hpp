#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.hpp"
#include "core/confrontation/measured_data.hpp"

namespace asperity {

/// Reads a measured file and the curves it names (paths relative to it), in the core's units. Throws Error(config) with
/// every fault found, each with its JSON pointer, or the CSV file and its line.
MeasuredData read_measured_data(const std::filesystem::path& path);

/// The same for a text; `origin` names it in syntax faults, and its folder is where curves are looked for.
MeasuredData parse_measured_data(const std::string& text, const std::filesystem::path& origin);

}  // namespace asperity
