#pragma once
#include <string>

#include "app/commands/commands.hpp"
#include "core/config/run_config.hpp"
#include "core/output/run_folder.hpp"

namespace asperity::app {

/// How a session over one run folder goes on the outside; results do not depend on it.
struct SessionOptions {
  int threads = 0;  ///< 0: by the mesh's size.
  bool render = true;
  bool quiet = false;
};

/// Runs a checked configuration from its start, in the folder it is given, and returns the exit code. `original` is the
/// configuration file's text.
int run_from_start(const RunConfig& config, const std::string& original, const std::filesystem::path& root,
                   ExistingRun existing, const SessionOptions& options);

/// Goes on with the run that lies in the folder; from its start where it left no checkpoint.
int resume_run(const std::filesystem::path& root, const SessionOptions& options);

}  // namespace asperity::app
