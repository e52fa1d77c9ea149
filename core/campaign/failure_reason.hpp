#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

namespace asperity {

/// The file's bytes from this position on; empty where there are none or it cannot be read.
std::string text_from(const std::filesystem::path& file, std::uintmax_t begin);

/// What a process that failed said: of what it printed the last line after "error: ", else the last line, else its exit
/// code in words.
std::string last_error(const std::string& printed, int exit_code);

/// The text in one line, and paths in the store as they stand relative to it: the same words wherever the store lies.
std::string one_line(std::string text, const std::filesystem::path& store);

}  // namespace asperity
