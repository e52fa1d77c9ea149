#pragma once
#include <filesystem>
#include <string>

#include "core/base/error.hpp"

namespace asperity {

/// The Error(output) for a file or folder that the system refused: path, what failed ("cannot be written"), the
/// system's own reason for `error_number` (an errno), and a hint where one helps.
Error output_error(const std::filesystem::path& path, const std::string& what, int error_number);

}  // namespace asperity
