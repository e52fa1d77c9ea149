#include "core/base/error.hpp"

#include <utility>

namespace asperity {

std::string describe(const Fault& fault) {
  std::string text = fault.where.empty() ? fault.what : fault.where + ": " + fault.what;
  std::string detail;
  if (!fault.value.empty()) detail += "found " + fault.value;
  if (!fault.allowed.empty()) detail += (detail.empty() ? "allowed: " : "; allowed: ") + fault.allowed;
  if (!detail.empty()) text += " (" + detail + ")";
  if (!fault.hint.empty()) text += ". Hint: " + fault.hint;
  return text;
}

namespace {
std::string join(const std::vector<Fault>& faults) {
  std::string text;
  for (const Fault& fault : faults) text += (text.empty() ? "" : "\n") + describe(fault);
  return text;
}
}  // namespace

Error::Error(ErrorKind kind, std::vector<Fault> faults)
    : std::runtime_error(join(faults)), kind_(kind), faults_(std::move(faults)) {}

Error::Error(ErrorKind kind, const std::string& what) : std::runtime_error(what), kind_(kind) {}

}  // namespace asperity
