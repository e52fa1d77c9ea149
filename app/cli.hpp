#pragma once

namespace asperity::app {

/// Parses the command line, runs the command and returns its exit code; prints every failure on stderr.
int run_command_line(int argc, char** argv);

}  // namespace asperity::app
