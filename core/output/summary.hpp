#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// summary.json: what a run found. Every key carries its unit; a value that was not reached is null.
struct Summary {
  nlohmann::ordered_json experiment = nlohmann::ordered_json::object();
  nlohmann::ordered_json results = nlohmann::ordered_json::object();
  nlohmann::ordered_json energy = nlohmann::ordered_json::object();
  nlohmann::ordered_json cracks = nlohmann::ordered_json::object();
  nlohmann::ordered_json failure_mode = nlohmann::ordered_json::object();  ///< Empty in files of before it was told.
  nlohmann::ordered_json contacts = nlohmann::ordered_json::object();
  nlohmann::ordered_json cost = nlohmann::ordered_json::object();
  std::vector<std::string> warnings;
};

/// Replaces the file atomically, keys in the order of the struct. Throws Error(output).
void write_summary(const std::filesystem::path& path, const Summary& summary);

/// Throws Error(output) where the file is missing, no JSON, or lacks one of the keys; "failure_mode" may be missing.
Summary read_summary(const std::filesystem::path& path);

/// The same for a text that is already there; `name` stands for the file in errors.
Summary parse_summary(std::string_view text, const std::filesystem::path& name);

}  // namespace asperity
