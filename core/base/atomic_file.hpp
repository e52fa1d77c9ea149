#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace asperity {

/// Writes the bytes beside `path` (as `path` + ".tmp"), syncs and renames, so a reader sees the old file or the new
/// one, never a part. The folder must exist and have one writer. Throws Error(output) with path and reason; the old
/// file stays.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

/// Makes the folder if it is missing; its parent must exist. Throws Error(output) with path and reason.
void make_folder(const std::filesystem::path& folder);

/// All bytes of a file. Throws Error(output) with path and reason.
std::string read_file(const std::filesystem::path& path);

}  // namespace asperity
