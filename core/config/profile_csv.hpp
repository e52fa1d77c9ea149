#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/base/error.hpp"

namespace asperity {

/// Replaces /joint/profile_csv of a run's configuration by the points of that file, as /joint/points_mm; the path counts
/// from `folder`. The file has a header, x_mm,y_mm, and two numbers a line. Returns what is wrong, at file:line.
std::vector<Fault> take_in_profile(nlohmann::json& document, const std::filesystem::path& folder);

}  // namespace asperity
