#pragma once
#include <string>

#include "app/documents/command_tree.hpp"

namespace asperity::app {

/// The manual page asperity(1) in the macros of man(7). `date` is YYYY-MM-DD.
std::string manual_page(const CommandTree& tree, const std::string& version, const std::string& date);

}  // namespace asperity::app
