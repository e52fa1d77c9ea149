#pragma once
#include "app/cli_options.hpp"

/// Commands that make many runs: tables of the paper's law, timings, campaigns, calibrations, confrontations,
/// galleries.
namespace asperity::app {

void add_audit(CLI::App& cli, Action& action);
void add_bench(CLI::App& cli, Action& action);
void add_acceleration(CLI::App& cli, Action& action);
void add_campaign(CLI::App& cli, Action& action);
void add_calibrate(CLI::App& cli, Action& action);
void add_confront(CLI::App& cli, Action& action);
void add_gallery(CLI::App& cli, Action& action);

}  // namespace asperity::app
