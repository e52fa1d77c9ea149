#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.hpp"
#include "core/config/run_config.hpp"

/// What a mechanism says of itself: from it come the switch in the run configuration, its schema, its checks and its
/// entry in the library. core/mechanism's files declare them.
namespace asperity {

/// A number that a mechanism takes.
struct MechanismParameter {
  std::string key;   ///< With its unit, as every JSON key.
  std::string unit;  ///< "1" where it has none.
  std::string description;
  double lowest = 0, highest = 0;  ///< Both allowed.
  double strong = 0;               ///< Its value at amplitude 1, the declared strong one.
  /// At amplitude 0, where the mechanism is off; unset: it does not follow the amplitude.
  std::optional<double> neutral = std::nullopt;
  /// Its inverse grows in proportion to the amplitude, from 0: off is infinite.
  bool reciprocal = false;
  bool whole = false;  ///< Takes whole numbers.
};

struct MechanismDeclaration {
  std::string id;
  std::string title;        ///< A few words for pages and plots.
  std::string equation;     ///< In words and symbols, with its number in core/mechanism/README.md.
  std::string source;       ///< Literature.
  std::string reason;       ///< Why the strong values are what they are, physically.
  std::string expectation;  ///< What a rock mechanician expects it to do.
  std::vector<ExperimentType> acts_in;
  std::vector<MechanismParameter> parameters;
  bool suspect = false;           ///< A setting of the solver or of the experiment's idealisation, no rock.
  bool default_law_only = false;  ///< Needs the default law in its first form.
  bool needs_general_contact = false;
  bool needs_breakable_particles = false;  ///< A joint with "breakable" false has no contact it could act on.
  bool allows_elastic_start = false;       ///< The static start knows it, or it acts later only.
};

/// Adds a declaration; the library's files do so before main() begins.
void declare_mechanism(const MechanismDeclaration& declaration);

/// All that are declared, in alphabetical order.
std::vector<MechanismDeclaration> declared_mechanisms();

/// nullptr where there is none of this type.
const MechanismDeclaration* find_mechanism(std::string_view id);

bool acts_in(const MechanismDeclaration& declaration, ExperimentType type);

/// All parameters of an entry: given ones, the others after its amplitude.
std::map<std::string, double> mechanism_values(const MechanismDeclaration& declaration, const MechanismConfig& config);

/// Whether an entry leaves the base model as it is: amplitude 0 and no parameter.
bool is_off(const MechanismConfig& config);

/// Faults of "/mechanisms": of a type that is twice, that does not act in this experiment or not with this law, and of
/// parameters that are another's or out of range.
std::vector<Fault> mechanism_faults(const RunConfig& config);

/// The schema of "/mechanisms" and what it may hold, made of the declarations.
nlohmann::ordered_json mechanisms_schema();

}  // namespace asperity
