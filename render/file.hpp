#pragma once
#include <filesystem>
#include <string_view>

namespace asperity::render {

/// Writes a whole file beside `path` and renames it, so `path` is never half-written; makes the folder if it is
/// missing. Errors: Error(output) with the path and the system's reason; nothing is left behind.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace asperity::render
