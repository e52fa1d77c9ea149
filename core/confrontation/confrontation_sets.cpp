#include <algorithm>

#include "core/config/enum_words.hpp"
#include "core/config/mechanism_declaration.hpp"
#include "core/config/schema_lookup.hpp"
#include "core/config/suggest.hpp"
#include "core/confrontation/confrontation_parts.hpp"
#include "core/confrontation/feature_rules.hpp"
#include "core/confrontation/proposed_split.hpp"
#include "core/confrontation/virtual_test.hpp"

namespace asperity::confrontation_parts {
namespace {

using nlohmann::json;

std::vector<std::string> ids_of(const MeasuredData& data) {
  std::vector<std::string> ids;
  for (const MeasuredTest& test : data.tests) ids.push_back(test.id);
  return ids;
}

Fault unknown_test(const ConfrontationConfig& config, const std::string& where, const std::string& id) {
  const std::vector<std::string> ids = ids_of(config.measured);
  return {where, "is no test of the measured file", "\"" + id + "\"", list_text(ids), near_hint(id, ids)};
}

/// A value by pointer: each must be a key of the run configuration.
void check_pointers(const json& set, const std::string& where, std::vector<Fault>& faults) {
  const json& schema = parsed_schema("run");
  for (const auto& [pointer, value] : set.items()) {
    const std::string place = where + ": " + pointer;
    const std::size_t slash = pointer.rfind('/');
    if (!is_json_pointer(pointer)) {
      faults.push_back({place, "is no JSON pointer", json_text(value), "e.g. \"/particles/edge_mm\"",
                        pointer.starts_with('/') ? "~ is written ~0 in it, and / inside a key ~1" : ""});
    } else if (!schema_at(schema, pointer)) {
      faults.push_back({place, "is no key of a run configuration", json_text(value), "its JSON pointer",
                        key_hint(schema, pointer.substr(0, slash), pointer.substr(slash + 1))});
    }
  }
}

std::vector<std::string> names(const json& document, const char* key) {
  return document.value(key, std::vector<std::string>{});
}

std::vector<std::string> library_ids() {
  std::vector<std::string> ids;
  for (const MechanismDeclaration& m : declared_mechanisms()) ids.push_back(m.id);
  return ids;
}

void check_ids(const std::vector<std::string>& given, const std::string& where, std::vector<Fault>& faults) {
  const std::vector<std::string> ids = library_ids();
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (find_mechanism(given[i])) continue;
    const std::string near = near_hint(given[i], ids);
    faults.push_back({where + "/" + std::to_string(i), "is no mechanism of the library", "\"" + given[i] + "\"",
                      list_text(ids), near.empty() ? "`asperity mechanisms` lists them" : near});
  }
}

/// `runs`: of each measured test.
bool acts_somewhere(const std::string& id, const MeasuredData& data, const std::vector<RunConfig>& runs) {
  for (std::size_t t = 0; t < runs.size(); ++t) {
    if (can_act(data.tests[t], runs[t], id)) return true;
  }
  return false;
}

std::vector<std::string> rule_names(ExperimentType type) {
  std::vector<std::string> all;
  for (const FeatureRule& rule : feature_rules(type)) all.emplace_back(rule.name);
  return all;
}

/// The names given for one experiment, in the order of the rules.
std::vector<std::string> chosen_features(const json& given, ExperimentType type, std::vector<Fault>& faults) {
  const std::vector<std::string> known = rule_names(type);
  std::vector<std::string> chosen;
  for (const std::string& name : known) {
    if (std::find(given.begin(), given.end(), name) != given.end()) chosen.push_back(name);
  }
  std::size_t index = 0;
  for (const json& name : given) {
    const std::string where = "/features/" + std::string(word(type)) + "/" + std::to_string(index++);
    if (find_feature_rule(type, name.get<std::string>())) continue;
    faults.push_back(
        {where, "is no feature that a confrontation compares", name.dump(), list_text(known), near_hint(name, known)});
  }
  return chosen;
}

}  // namespace

std::string near_hint(const std::string& word, const std::vector<std::string>& known) {
  const std::string near = closest(word, known);
  return near.empty() ? "" : "did you mean " + near + "?";
}

std::string list_text(const std::vector<std::string>& words) {
  constexpr std::size_t kMost = 30;
  std::string text;
  for (std::size_t i = 0; i < std::min(words.size(), kMost); ++i) text += (i == 0 ? "" : ", ") + words[i];
  return words.size() > kMost ? text + ", ..." : text;
}

void read_sets(ConfrontationConfig& config, std::vector<Fault>& faults) {
  config.set = config.document.value("set", json::object());
  check_pointers(config.set, "/set", faults);
  const json tests = config.document.value("tests", json::object());
  for (const auto& [id, entry] : tests.items()) {
    const std::string where = child_pointer("/tests", id);
    if (!find_test(config.measured, id)) faults.push_back(unknown_test(config, where, id));
    if (!entry.is_object() || entry.size() != 1 || !entry.contains("set") || !entry.at("set").is_object()) {
      faults.push_back(
          {where, "is no object with the key \"set\"", json_text(entry), "{\"set\": {\"/json/pointer\": value}}", ""});
      continue;
    }
    config.test_set[id] = entry.at("set");
    check_pointers(entry.at("set"), where + "/set", faults);
  }
}

void read_split(ConfrontationConfig& config, std::vector<Fault>& faults) {
  MeasuredData& data = config.measured;
  const bool given = config.document.contains("hold_out");
  const bool used =
      std::any_of(data.tests.begin(), data.tests.end(), [](const MeasuredTest& t) { return t.use.has_value(); });
  config.split_proposed = !given && !used;
  if (config.split_proposed) return propose_split(data);
  const std::vector<std::string> ids = names(config.document, "hold_out");
  for (MeasuredTest& test : data.tests) {
    const bool named = std::find(ids.begin(), ids.end(), test.id) != ids.end();
    const TestUse otherwise = given ? TestUse::fit : test.use.value_or(TestUse::fit);
    test.use = named ? TestUse::hold_out : otherwise;
  }
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (!find_test(data, ids[i])) faults.push_back(unknown_test(config, "/hold_out/" + std::to_string(i), ids[i]));
  }
  if (std::none_of(data.tests.begin(), data.tests.end(), [](const MeasuredTest& t) { return t.use == TestUse::fit; }))
    faults.push_back({"/hold_out", "leaves no test to be fitted", list_text(ids_of(data)), "fewer tests", ""});
}

void read_compared_features(ConfrontationConfig& config, std::vector<Fault>& faults) {
  const json given = config.document.value("features", json::object());
  for (const ExperimentType type : experiments_of(config.measured)) {
    const std::string key(word(type));
    config.features[type] = given.contains(key) ? chosen_features(given.at(key), type, faults) : rule_names(type);
  }
}

void read_candidates(ConfrontationConfig& config, const std::vector<RunConfig>& runs, std::vector<Fault>& faults) {
  const bool given = config.document.contains("mechanisms");
  std::vector<std::string> ids = given ? names(config.document, "mechanisms") : library_ids();
  const std::vector<std::string> without = names(config.document, "without");
  const std::size_t before = faults.size();
  check_ids(ids, "/mechanisms", faults);
  check_ids(without, "/without", faults);
  if (faults.size() != before) return;
  std::sort(ids.begin(), ids.end());
  for (const std::string& id : ids) {
    if (std::find(without.begin(), without.end(), id) != without.end()) continue;
    if (acts_somewhere(id, config.measured, runs)) {
      config.mechanisms.push_back(id);
    } else if (given) {
      faults.push_back({"/mechanisms", "names one that cannot be added to any of the virtual tests", "\"" + id + "\"",
                        "a mechanism that acts in one of the experiments and that the bases do not have", "remove it"});
    }
  }
  for (const MechanismDeclaration& m : declared_mechanisms()) {
    const auto& among = config.mechanisms;
    if (m.suspect && std::find(among.begin(), among.end(), m.id) == among.end() &&
        acts_somewhere(m.id, config.measured, runs))
      config.left_out_suspects.push_back(m.id);
  }
}

}  // namespace asperity::confrontation_parts
