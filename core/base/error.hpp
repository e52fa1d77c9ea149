#pragma once
#include <stdexcept>
#include <string>
#include <vector>

namespace asperity {

/// Exit code of the command line for each kind of failure.
enum class ErrorKind { unexpected = 1, usage = 2, config = 3, numerical = 4, output = 5, tolerance = 6 };

/// One thing that is wrong with what the user gave, in the form every user error is printed.
struct Fault {
  std::string where;    ///< JSON pointer, or file:line.
  std::string what;     ///< What is wrong, one clause.
  std::string value;    ///< The value found, as written; empty if there is none.
  std::string allowed;  ///< What is allowed there, with its unit; empty if it does not apply.
  std::string hint;     ///< What to do; empty if nothing helps.
};

/// "/experiment/diameter_mm: must be above 0 (found -5; allowed: 1 to 1000 mm). Hint: ...".
std::string describe(const Fault& fault);

/// A failure with a defined exit code. User errors list every fault found; numerical and output errors carry one.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, std::vector<Fault> faults);
  Error(ErrorKind kind, const std::string& what);
  ErrorKind kind() const { return kind_; }
  const std::vector<Fault>& faults() const { return faults_; }

 private:
  ErrorKind kind_;
  std::vector<Fault> faults_;
};

}  // namespace asperity
