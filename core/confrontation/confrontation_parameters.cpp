#include <algorithm>

#include "core/config/enum_words.hpp"
#include "core/config/schema_lookup.hpp"
#include "core/confrontation/config_numbers.hpp"
#include "core/confrontation/confrontation_parts.hpp"

namespace asperity::confrontation_parts {
namespace {

using nlohmann::json;

std::vector<ExperimentType> experiments(const json& entry, const std::vector<ExperimentType>& present) {
  if (!entry.contains("only")) return present;
  std::vector<ExperimentType> list;
  for (const json& name : entry.at("only")) {
    const auto type = from_word<ExperimentType>(name.get<std::string>());
    if (std::find(present.begin(), present.end(), type) != present.end()) list.push_back(type);
  }
  return list;
}

ConfrontationParameter read_parameter(const json& entry, const std::vector<ExperimentType>& present) {
  ConfrontationParameter p;
  p.name = entry.at("name");
  p.label = entry.value("label", p.name);
  p.pointer = entry.at("pointer");
  p.tied = entry.value("tied", p.tied);
  const std::string transform = entry.value("transform", "log");
  p.transform = transform == "tangent"  ? ParameterTransform::tangent
                : transform == "linear" ? ParameterTransform::linear
                                        : ParameterTransform::log;
  p.step = entry.at("step");
  p.lower = entry.at("lower");
  p.upper = entry.at("upper");
  p.only = experiments(entry, present);
  const json* node = is_json_pointer(p.pointer) ? schema_at(parsed_schema("run"), p.pointer) : nullptr;
  p.unit = entry.value("unit", node ? node->value("unit", "1") : "1");
  return p;
}

/// A number of the run configuration.
void check_pointer(const std::string& pointer, const std::string& where, std::vector<Fault>& faults) {
  const json& schema = parsed_schema("run");
  const bool legal = is_json_pointer(pointer);
  const json* node = legal ? schema_at(schema, pointer) : nullptr;
  if (node && single_type(*node) == "number") return;
  const std::size_t slash = pointer.rfind('/');
  const bool hint = legal && !node;
  faults.push_back({where, node ? "is no number that could be moved" : "is no microparameter of the model", pointer,
                    "the JSON pointer of a number in a run configuration, e.g. /contacts/cohesion_mpa",
                    hint ? key_hint(schema, pointer.substr(0, slash), pointer.substr(slash + 1)) : ""});
}

constexpr double kWidestStep = 3.0;  // over the way from lower to upper

void check_range(const ConfrontationParameter& p, const std::string& where, std::vector<Fault>& faults) {
  if (p.lower >= p.upper) {
    faults.push_back({where + "/lower", "does not lie below upper", number_text(p.lower),
                      "below " + number_text(p.upper), "exchange lower and upper"});
  } else if (p.transform == ParameterTransform::log && p.lower <= 0.0) {
    faults.push_back(
        {where + "/lower", "has no logarithm", number_text(p.lower), "above 0", "or \"transform\": \"linear\""});
  } else if (p.transform == ParameterTransform::tangent && (p.lower < 0.0 || p.upper >= 90.0)) {
    faults.push_back({where + (p.lower < 0.0 ? "/lower" : "/upper"), "is no angle of friction",
                      number_text(p.lower < 0.0 ? p.lower : p.upper), "from 0, below 90 deg", ""});
  } else if (const double width = theta_of(p.transform, p.upper) - theta_of(p.transform, p.lower);
             p.step > kWidestStep * width) {
    faults.push_back({where + "/step", "is far wider than the way from lower to upper", number_text(p.step),
                      "at most " + number_text(kWidestStep * width),
                      "a finite difference: of a logarithm 0.08 is 8 %"});
  }
}

/// A value that a virtual test must have, not a default that is derived.
std::optional<double> value_in(const RunConfig& test, const std::string& pointer, const std::string& where,
                               std::vector<Fault>& faults) {
  const std::optional<double> value = number_of(test, pointer);
  if (value) return value;
  faults.push_back({where, "is not set in the base for " + std::string(word(test.experiment.type)), pointer,
                    "a number in every base where the parameter acts",
                    "write the value in force into the base (`asperity derive` tells it): a default that is derived "
                    "cannot be moved"});
  return std::nullopt;
}

/// The bases' value, the same in all.
void take_reference(ConfrontationParameter& p, const RunConfig& test, bool& found, const std::string& where,
                    std::vector<Fault>& faults) {
  const std::optional<double> value = value_in(test, p.pointer, where + "/pointer", faults);
  if (!value) return;
  if (found && *value != p.reference) {
    faults.push_back({where + "/pointer", "has another value in the virtual test " + test.name, number_text(*value),
                      number_text(p.reference) + ", as in the tests before it",
                      "one value in all bases, or \"only\" for the experiments in which it acts"});
  }
  if (!found) p.reference = *value;
  found = true;
}

void check_reference(const ConfrontationParameter& p, const std::string& where, std::vector<Fault>& faults) {
  if (p.reference >= p.lower && p.reference <= p.upper) return;
  faults.push_back({where, "starts outside its own range: the bases have " + number_text(p.reference), p.pointer,
                    number_text(p.lower) + " to " + number_text(p.upper) + " " + p.unit, "widen lower or upper"});
}

/// Reference and tied values over the tests; false where it acts in none.
bool take_references(ConfrontationParameter& p, const std::vector<RunConfig>& tests, const std::string& where,
                     std::vector<Fault>& faults) {
  const std::size_t before = faults.size();
  bool found = false, acts = false;
  std::vector<ExperimentType> seen;
  for (const RunConfig& test : tests) {
    if (!acts_in(p, test.experiment.type)) continue;
    acts = true;
    take_reference(p, test, found, where, faults);
    if (std::find(seen.begin(), seen.end(), test.experiment.type) != seen.end()) continue;
    seen.push_back(test.experiment.type);
    for (std::size_t i = 0; i < p.tied.size(); ++i)
      value_in(test, p.tied[i], where + "/tied/" + std::to_string(i), faults);
  }
  if (acts && faults.size() == before) check_reference(p, where, faults);
  return acts;
}

void check_tied(const ConfrontationParameter& p, const std::string& where, std::vector<Fault>& faults) {
  for (std::size_t i = 0; i < p.tied.size(); ++i)
    check_pointer(p.tied[i], where + "/tied/" + std::to_string(i), faults);
  if (p.tied.empty() || p.lower > 0.0) return;
  faults.push_back({where + "/tied", "cannot keep its proportion to a value that may be 0", number_text(p.lower),
                    "lower above 0", ""});
}

/// Names and pointers that two parameters share.
void check_twice(const std::vector<ConfrontationParameter>& all, std::size_t i, const std::string& where,
                 std::vector<Fault>& faults) {
  const auto pointers = [](const ConfrontationParameter& p) {
    std::vector<std::string> list = p.tied;
    list.push_back(p.pointer);
    return list;
  };
  std::vector<std::string> own = pointers(all[i]);
  std::sort(own.begin(), own.end());
  if (const auto same = std::adjacent_find(own.begin(), own.end()); same != own.end())
    faults.push_back(
        {where + "/tied", "names a pointer that the parameter moves already", *same, "each pointer once", ""});
  for (std::size_t j = 0; j < i; ++j) {
    if (all[j].name == all[i].name)
      faults.push_back(
          {where + "/name", "is another parameter's too", "\"" + all[i].name + "\"", "each name once", ""});
    for (const std::string& other : pointers(all[j])) {
      if (std::find(own.begin(), own.end(), other) != own.end())
        faults.push_back({where, "moves what " + all[j].name + " moves", other, "each pointer once", ""});
    }
  }
}

/// "calibrate": which parameters may move.
void choose_calibrated(ConfrontationConfig& config, std::vector<Fault>& faults) {
  if (!config.document.contains("calibrate")) return;
  std::vector<std::string> known, chosen = config.document.at("calibrate");
  for (ConfrontationParameter& p : config.parameters) {
    known.push_back(p.name);
    p.calibrated = std::find(chosen.begin(), chosen.end(), p.name) != chosen.end();
  }
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (std::find(known.begin(), known.end(), chosen[i]) != known.end()) continue;
    faults.push_back({"/calibrate/" + std::to_string(i), "is no name of a parameter", "\"" + chosen[i] + "\"",
                      list_text(known), near_hint(chosen[i], known)});
  }
}

}  // namespace

void read_parameters(ConfrontationConfig& config, const std::vector<RunConfig>& tests, std::vector<Fault>& faults) {
  const std::vector<ExperimentType> present = experiments_of(config.measured);
  for (const json& entry : config.document.value("parameters", json::array()))
    config.parameters.push_back(read_parameter(entry, present));
  choose_calibrated(config, faults);
  std::vector<ConfrontationParameter> acting;
  for (std::size_t i = 0; i < config.parameters.size(); ++i) {
    ConfrontationParameter& p = config.parameters[i];
    const std::string where = "/parameters/" + std::to_string(i);
    const std::size_t before = faults.size();
    check_pointer(p.pointer, where + "/pointer", faults);
    check_range(p, where, faults);
    check_tied(p, where, faults);
    check_twice(config.parameters, i, where, faults);
    if (faults.size() != before) continue;
    if (take_references(p, tests, where, faults)) {
      acting.push_back(p);
    } else {
      config.idle_parameters.push_back(p.name);
    }
  }
  config.parameters = std::move(acting);
}

}  // namespace asperity::confrontation_parts
