#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

/// What the commands have in common on the command line.
namespace asperity::app {

using Action = std::function<int()>;

/// Names of the kinds of values, as --help shows them. Completion and manual take from them what a value may be
/// (app/documents/command_tree.hpp).
inline constexpr const char* kConfig = "CONFIG";        ///< A JSON file.
inline constexpr const char* kFolder = "DIR";           ///< A folder.
inline constexpr const char* kFile = "FILE";            ///< Any file.
inline constexpr const char* kField = "FIELD";          ///< What a picture shows.
inline constexpr const char* kMechanism = "MECHANISM";  ///< The id of one.
inline constexpr const char* kSchemaKind = "KIND";      ///< A kind of configuration.
inline constexpr const char* kOverride = "POINTER=VALUE";

/// The positional argument "config" that a command needs.
void add_config(CLI::App& command, std::filesystem::path& config, const std::string& description);

/// The option --set.
void add_overrides(CLI::App& command, std::vector<std::string>& overrides);

}  // namespace asperity::app
