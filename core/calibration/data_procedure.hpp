#pragma once
#include <filesystem>

#include "core/calibration/data_calibration.hpp"

namespace asperity {

/// Reads, analyses and writes a calibration of kind "data": `folder`/calibration.json, and `folder`/audit.md where the
/// config says what was published. The folder is there. Throws what reading throws, and Error(output).
Analysis calibrate_data(const std::filesystem::path& config, const std::filesystem::path& folder);

}  // namespace asperity
