#include <algorithm>
#include <cmath>

#include "core/config/enum_words.hpp"
#include "core/config/mechanism_declaration.hpp"
#include "core/config/schema_lookup.hpp"
#include "core/config/suggest.hpp"

namespace asperity {
namespace {

constexpr const char* kRemove = "remove it";

std::string list(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::vector<std::string> keys_of(const MechanismDeclaration& m) {
  std::vector<std::string> keys{"amplitude"};
  for (const MechanismParameter& p : m.parameters) keys.push_back(p.key);
  return keys;
}

std::string experiments_of(const MechanismDeclaration& m) {
  std::vector<std::string> words;
  for (const ExperimentType type : m.acts_in) words.emplace_back(word(type));
  return list(words);
}

std::string range_of(const MechanismParameter& p) {
  const std::string unit = p.unit == "1" ? "" : " " + p.unit;
  return number_text(p.lowest) + " to " + number_text(p.highest) + unit + (p.whole ? ", a whole number" : "");
}

Fault unknown_type(const std::string& where, const MechanismConfig& entry) {
  std::vector<std::string> ids;
  for (const MechanismDeclaration& m : declared_mechanisms()) ids.push_back(m.id);
  const std::string near = closest(entry.type, ids);
  return {where + "/type", "is no mechanism of the library", "\"" + entry.type + "\"", list(ids),
          near.empty() ? "`asperity mechanisms` lists them" : "did you mean \"" + near + "\"?"};
}

Fault unknown_parameter(const std::string& where, const MechanismDeclaration& m, const std::string& key, double value) {
  const std::string near = closest(key, keys_of(m));
  return {where + "/" + key, "is not a parameter of " + m.id, number_text(value), list(keys_of(m)),
          near.empty() ? kRemove : "did you mean " + near + "?"};
}

void check_parameters(const std::string& where, const MechanismDeclaration& m, const MechanismConfig& entry,
                      std::vector<Fault>& faults) {
  for (const auto& [key, value] : entry.parameters) {
    const auto p =
        std::find_if(m.parameters.begin(), m.parameters.end(), [&, k = key](const auto& q) { return q.key == k; });
    if (p == m.parameters.end()) {
      faults.push_back(unknown_parameter(where, m, key, value));
    } else if (value < p->lowest || value > p->highest || (p->whole && value != std::round(value))) {
      faults.push_back({where + "/" + key, "is out of range", number_text(value), range_of(*p), p->description});
    }
  }
}

/// The amplitude may lead a parameter out of its range.
void check_amplitude(const std::string& where, const MechanismDeclaration& m, const MechanismConfig& entry,
                     std::vector<Fault>& faults) {
  if (!entry.amplitude || *entry.amplitude == 0.0) return;
  const auto values = mechanism_values(m, entry);
  for (const MechanismParameter& p : m.parameters) {
    const double value = values.at(p.key);
    if (entry.parameters.contains(p.key) || (value >= p.lowest && value <= p.highest)) continue;
    faults.push_back({where + "/amplitude", "leads " + p.key + " out of its range, to " + number_text(value),
                      number_text(*entry.amplitude), p.key + " " + range_of(p), "give a smaller amplitude"});
    return;
  }
}

void check_place(const std::string& where, const MechanismDeclaration& m, const RunConfig& config,
                 std::vector<Fault>& faults) {
  const std::string type = "\"" + m.id + "\"";
  const LawConfig& law = config.contacts.law;
  if (!acts_in(m, config.experiment.type)) {
    faults.push_back({where + "/type", "does nothing in this experiment, " + std::string(word(config.experiment.type)),
                      type, "a mechanism that acts in it; this one acts in " + experiments_of(m), kRemove});
  } else if (m.default_law_only && (law.reading != LawReading::consistent || law.form != LawForm::damage_slip)) {
    faults.push_back({where + "/type", "is a change of the default law in its form \"damage_slip\"", type,
                      "/contacts/law/reading \"default\", /contacts/law/form \"damage_slip\"",
                      "change the law, or remove it"});
  } else if (m.needs_general_contact && !config.contacts.general.enabled) {
    faults.push_back({where + "/type", "acts on surfaces in general contact, which is off", type,
                      "/contacts/general/enabled true", "switch it on, or remove the mechanism"});
  } else if (m.needs_breakable_particles && config.experiment.type == ExperimentType::direct_shear &&
             !config.joint.breakable) {
    faults.push_back({where + "/type", "acts on contacts between particles, and this joint's halves have none", type,
                      "/joint/breakable true", "set it, or remove the mechanism"});
  } else if (!m.allows_elastic_start && config.experiment.loading.elastic_start_fraction > 0.0) {
    faults.push_back({where + "/type", "cannot go with an elastic start, whose equilibria do not know it", type,
                      "/experiment/loading/elastic_start_fraction 0", "set it to 0, or remove the mechanism"});
  }
}

}  // namespace

std::vector<Fault> mechanism_faults(const RunConfig& config) {
  std::vector<Fault> faults;
  std::vector<std::string> seen;
  for (std::size_t i = 0; i < config.mechanisms.size(); ++i) {
    const MechanismConfig& entry = config.mechanisms[i];
    const std::string where = "/mechanisms/" + std::to_string(i);
    const MechanismDeclaration* m = find_mechanism(entry.type);
    if (!m) {
      faults.push_back(unknown_type(where, entry));
      continue;
    }
    if (std::find(seen.begin(), seen.end(), entry.type) != seen.end()) {
      faults.push_back({where + "/type", "is in the list twice", "\"" + entry.type + "\"", "each type once", kRemove});
    }
    seen.push_back(entry.type);
    check_parameters(where, *m, entry, faults);
    check_amplitude(where, *m, entry, faults);
    check_place(where, *m, config, faults);
  }
  return faults;
}

}  // namespace asperity
