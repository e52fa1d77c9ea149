#pragma once
#include <string>

#include "app/documents/command_tree.hpp"

namespace asperity::app {

/// Scripts that complete commands, options and their values. A value is completed by what it is: JSON files and folders
/// for a configuration, folders, files, the words that are allowed, or, after --set, the keys of a run configuration.
std::string bash_completion(const CommandTree& tree);
std::string zsh_completion(const CommandTree& tree);
std::string fish_completion(const CommandTree& tree);

}  // namespace asperity::app
