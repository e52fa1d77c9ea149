#include "core/mechanism/mechanism.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "core/config/cross_checks.hpp"

namespace asperity {
namespace {

std::map<std::string, Mechanism, std::less<>>& library() {
  static std::map<std::string, Mechanism, std::less<>> all;
  return all;
}

/// Of an entry that has passed the checks of the configuration.
const Mechanism& mechanism_of(const MechanismConfig& entry) {
  const auto found = library().find(entry.type);
  assert(found != library().end() && "a mechanism that the checks should have refused");
  return found->second;
}

MechanismValues values_of(const Mechanism& mechanism, const MechanismConfig& entry) {
  return MechanismValues(mechanism_values(mechanism.declaration, entry));
}

/// Some settings read what others set: in alphabetical order every list of the same entries is the same run.
std::vector<MechanismConfig> by_name(std::vector<MechanismConfig> entries) {
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.type < b.type; });
  return entries;
}

}  // namespace

Registered::Registered(const Mechanism& mechanism) {
  declare_mechanism(mechanism.declaration);
  library()[mechanism.declaration.id] = mechanism;
}

RunConfig with_mechanisms(const RunConfig& config) {
  RunConfig result = config;
  for (const MechanismConfig& entry : by_name(config.mechanisms)) {
    const Mechanism& mechanism = mechanism_of(entry);
    if (mechanism.set && !is_off(entry)) mechanism.set(values_of(mechanism, entry), result);
  }
  if (std::vector<Fault> faults = cross_check(result); !faults.empty() && !config.mechanisms.empty()) {
    for (Fault& fault : faults) fault.hint = "a mechanism has set it: change /mechanisms. " + fault.hint;
    throw Error(ErrorKind::config, std::move(faults));
  }
  return result;
}

bool marks_contacts(std::string_view id) {
  const auto found = library().find(id);
  return found != library().end() && found->second.mark != nullptr;
}

void mark_contacts(const RunConfig& config, const Mesh& mesh, const Particles& particles, BondedContacts& contacts) {
  ContactMarks marks{std::vector<double>(contacts.size(), 1.0), std::vector<std::uint8_t>(contacts.size(), 0)};
  bool marked = false;
  for (const MechanismConfig& entry : config.mechanisms) {
    const Mechanism& mechanism = mechanism_of(entry);
    if (!mechanism.mark || is_off(entry)) continue;
    mechanism.mark(values_of(mechanism, entry), {config, mesh, particles, contacts}, marks);
    marked = true;
  }
  if (!marked) return;
  const bool differ = std::any_of(marks.strength.begin(), marks.strength.end(), [](double f) { return f != 1.0; });
  if (differ) set_strengths(contacts, marks.strength);
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (marks.defects[c]) open_from_start(contacts, c);
  }
}

}  // namespace asperity
