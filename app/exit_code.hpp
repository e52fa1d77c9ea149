#pragma once
#include <iosfwd>
#include <string>
#include <vector>

#include "core/base/error.hpp"

namespace asperity {

inline constexpr int kExitDone = 0;
inline constexpr int kExitInterrupted = 130;  ///< Ctrl-C or SIGTERM; a checkpoint was left.

struct ExitCodeMeaning {
  int code;
  std::string meaning;
};

/// Every exit code, ascending.
const std::vector<ExitCodeMeaning>& exit_code_meanings();

/// "Exit codes: 0 done, 1 unexpected, ... ."
std::string exit_codes_in_a_line();

/// Exit code of a kind of failure, 1 to 6.
int exit_code(ErrorKind kind);

/// Exit code for what CLI11 wants to end with: 0 (help, version) stays, its own 100 to 127 become 2 (usage).
int exit_code_of_command_line(int cli11_code);

/// Explains the exception being handled on `err`, every fault on a line of its own after "error: ", and returns its
/// exit code: an Error's kind, else 1. Call it inside a catch block.
int report_current_exception(std::ostream& err);

}  // namespace asperity
