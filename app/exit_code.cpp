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
