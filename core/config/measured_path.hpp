#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/base/error.hpp"

namespace asperity {

/// Makes /output/measured_curve of a run's configuration, which counts from `folder`, an absolute path, and fills
/// /output/measured_name with the file's name where it is unset. Returns what is wrong: no such file, or a name without
/// a file.
std::vector<Fault> take_in_measured_curve(nlohmann::json& document, const std::filesystem::path& folder);

}  // namespace asperity
