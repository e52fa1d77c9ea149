#pragma once
#include <cassert>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/config/mechanism_declaration.hpp"
#include "core/contact/bonded_contacts.hpp"
#include "core/geometry/mesh.hpp"
#include "core/particles/particles.hpp"

/// A switchable mechanism: one file in core/mechanism/library that declares it and says what it does. It does it at two
/// places: to the settings of a run before the model is built (`set`), and to single contacts once they are there
/// (`mark`). Later stages read plain data only: RunConfig, ModelExtensions, BondedContacts.
namespace asperity {

/// The parameters of a mechanism that is on.
class MechanismValues {
 public:
  explicit MechanismValues(std::map<std::string, double> values) : values_(std::move(values)) {}
  /// Of a declared key.
  double operator()(std::string_view key) const {
    const auto found = values_.find(std::string(key));
    assert(found != values_.end() && "a parameter that was not declared");
    return found->second;
  }

 private:
  std::map<std::string, double> values_;
};

/// What a mechanism may look at when it marks contacts.
struct ContactSite {
  const RunConfig& config;
  const Mesh& mesh;
  const Particles& particles;
  const BondedContacts& contacts;
};

/// What mechanisms say of single contacts.
struct ContactMarks {
  std::vector<double> strength;       ///< Factor on each contact's strengths; 1 where nothing was said.
  std::vector<std::uint8_t> defects;  ///< 1 where a contact is open from the start.
};

struct Mechanism {
  MechanismDeclaration declaration;
  void (*set)(const MechanismValues& values, RunConfig& config) = nullptr;
  void (*mark)(const MechanismValues& values, const ContactSite& site, ContactMarks& marks) = nullptr;
};

/// Enters a mechanism into the library: `const Registered kEntry{mechanism()};` at namespace scope of its file.
struct Registered {
  explicit Registered(const Mechanism& mechanism);
};

/// The configuration with what its mechanisms set; throws a config error where that contradicts itself. The list of
/// mechanisms stays, for the record: do not apply it twice.
RunConfig with_mechanisms(const RunConfig& config);

/// Whether a mechanism of the library gives single contacts strengths of their own or opens them.
bool marks_contacts(std::string_view id);

/// Lets the mechanisms mark the contacts of a model: strengths and open contacts. No mark, no change.
void mark_contacts(const RunConfig& config, const Mesh& mesh, const Particles& particles, BondedContacts& contacts);

}  // namespace asperity
