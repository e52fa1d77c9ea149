#include <algorithm>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands/commands.hpp"
#include "core/base/error.hpp"
#include "core/config/enum_words.hpp"
#include "core/config/mechanism_declaration.hpp"
#include "core/config/schema_lookup.hpp"
#include "core/config/suggest.hpp"

namespace asperity::app {

using Json = nlohmann::ordered_json;

namespace {

std::vector<std::string> experiments_of(const MechanismDeclaration& m) {
  std::vector<std::string> words;
  for (const ExperimentType type : m.acts_in) words.emplace_back(word(type));
  return words;
}

Json parameter_json(const MechanismParameter& p) {
  Json j = {{"key", p.key},       {"unit", p.unit},       {"description", p.description},
            {"lowest", p.lowest}, {"highest", p.highest}, {"strong", p.strong}};
  if (p.neutral) j["neutral"] = *p.neutral;
  j["reciprocal"] = p.reciprocal;
  return j;
}

Json mechanism_json(const MechanismDeclaration& m) {
  Json j = {{"id", m.id},
            {"title", m.title},
            {"equation", m.equation},
            {"source", m.source},
            {"reason", m.reason},
            {"expectation", m.expectation},
            {"suspect", m.suspect},
            {"acts_in", experiments_of(m)},
            {"parameters", Json::array()}};
  for (const MechanismParameter& p : m.parameters) j["parameters"].push_back(parameter_json(p));
  return j;
}

void print_one(const MechanismDeclaration& m) {
  std::cout << m.id << ": " << m.title << "\n  " << m.equation << "\n  source: " << m.source << "\n  acts in:";
  for (const std::string& type : experiments_of(m)) std::cout << " " << type;
  std::cout << "\n  expected: " << m.expectation << "\n";
  for (const MechanismParameter& p : m.parameters) {
    const std::string unit = p.unit == "1" ? "" : " " + p.unit;
    std::cout << "  " << p.key << ": " << p.description << "; " << number_text(p.lowest) << " to "
              << number_text(p.highest) << unit << ", strong " << number_text(p.strong) << unit << "\n";
  }
  std::cout << "  why strong: " << m.reason << "\n";
}

void print_list(const std::vector<MechanismDeclaration>& all) {
  for (const MechanismDeclaration& m : all) std::cout << std::left << std::setw(22) << m.id << m.title << "\n";
}

}  // namespace

const MechanismDeclaration& mechanism_or_fault(const std::string& id) {
  if (const MechanismDeclaration* m = find_mechanism(id)) return *m;
  std::vector<std::string> ids;
  std::string allowed;
  for (const MechanismDeclaration& m : declared_mechanisms()) {
    ids.push_back(m.id);
    allowed += (allowed.empty() ? "" : ", ") + m.id;
  }
  const std::string near = closest(id, ids);
  throw Error(ErrorKind::usage,
              {{"mechanism", "is none of the library", id, allowed, near.empty() ? "" : "did you mean " + near + "?"}});
}

int mechanisms_command(const MechanismsOptions& options) {
  std::vector<MechanismDeclaration> chosen;
  for (const std::string& id : options.ids) chosen.push_back(mechanism_or_fault(id));
  const bool all = chosen.empty();
  if (all) chosen = declared_mechanisms();
  if (options.json) {
    Json list = Json::array();
    for (const MechanismDeclaration& m : chosen) list.push_back(mechanism_json(m));
    std::cout << list.dump(2) << "\n";
  } else if (all) {
    print_list(chosen);
  } else {
    for (const MechanismDeclaration& m : chosen) print_one(m);
  }
  return 0;
}

}  // namespace asperity::app
