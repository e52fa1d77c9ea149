#include "app/exit_code.hpp"

#include <exception>
#include <new>
#include <ostream>

namespace asperity {
namespace {

void report(const Error& error, std::ostream& err) {
  if (error.faults().empty()) err << "error: " << error.what() << '\n';
  for (const Fault& fault : error.faults()) err << "error: " << describe(fault) << '\n';
}

}  // namespace

const std::vector<ExitCodeMeaning>& exit_code_meanings() {
  static const std::vector<ExitCodeMeaning> meanings{{kExitDone, "done"},
                                                     {exit_code(ErrorKind::unexpected), "unexpected"},
                                                     {exit_code(ErrorKind::usage), "usage"},
                                                     {exit_code(ErrorKind::config), "config or data"},
                                                     {exit_code(ErrorKind::numerical), "numerical"},
                                                     {exit_code(ErrorKind::output), "output"},
                                                     {exit_code(ErrorKind::tolerance), "outside tolerance"},
                                                     {kExitInterrupted, "interrupted with a checkpoint"}};
  return meanings;
}

std::string exit_codes_in_a_line() {
  std::string line;
  for (const auto& [code, meaning] : exit_code_meanings()) {
    line += (line.empty() ? "Exit codes: " : ", ") + std::to_string(code) + " " + meaning;
  }
  return line + ".";
}

int exit_code(ErrorKind kind) { return static_cast<int>(kind); }

int exit_code_of_command_line(int cli11_code) {
  return cli11_code == kExitDone ? kExitDone : exit_code(ErrorKind::usage);
}

int report_current_exception(std::ostream& err) {
  try {
    throw;
  } catch (const Error& error) {
    report(error, err);
    return exit_code(error.kind());
  } catch (const std::bad_alloc&) {
    err << "error: not enough memory. Hint: a larger edge_mm makes fewer particles\n";
  } catch (const std::exception& unexpected) {
    err << "error: unexpected: " << unexpected.what() << '\n';
  } catch (...) {
    err << "error: unexpected failure of unknown kind\n";
  }
  return exit_code(ErrorKind::unexpected);
}

}  // namespace asperity
