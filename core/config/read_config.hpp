#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.hpp"
#include "core/config/run_config.hpp"

namespace asperity {

/// Reads a run configuration, lays the overrides ("/json/pointer=value", later ones win) over it, and checks it against
/// the schema and across keys. Throws one Error: of kind config with every fault found, each with its JSON pointer or
/// file:line:column; or of kind usage if an override is malformed.
RunConfig read_run_config(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

/// The text of a configuration of any kind. Throws Error(config) where it cannot be read.
std::string read_config_text(const std::filesystem::path& path);

/// The kind of a configuration by the file name of its "$schema", KIND.schema.json. Where it names none:
/// "measured" of a file with "tests" and no "experiment", else "run". Throws Error(config) where the file cannot be read.
std::string config_kind(const std::filesystem::path& path);

/// The same as read_run_config for a text; `origin` names it in syntax faults, and its stem is the run's name if the
/// text has none.
RunConfig parse_run_config(const std::string& text, const std::string& origin,
                           const std::vector<std::string>& overrides = {});

}  // namespace asperity
