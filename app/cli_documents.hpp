#pragma once
#include "app/cli_options.hpp"

/// Commands that print the command line itself: completion scripts and the manual.
namespace asperity::app {

void add_completion(CLI::App& cli, Action& action);
void add_manual(CLI::App& cli, Action& action);

}  // namespace asperity::app
