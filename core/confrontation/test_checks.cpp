#include "core/confrontation/test_checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "core/config/enum_words.hpp"
#include "core/config/schema_lookup.hpp"
#include "core/config/suggest.hpp"
#include "core/confrontation/column_units.hpp"
#include "core/measurement/features.hpp"

namespace asperity {
namespace {

using nlohmann::json;

/// A key and the experiments that have it.
struct KeyUse {
  const char* key;
  bool (*applies)(ExperimentType);
  bool required;
  const char* where;
};

bool compression(ExperimentType e) { return is_compression(e); }
bool disc(ExperimentType e) { return e == ExperimentType::brazilian; }
bool joint(ExperimentType e) { return e == ExperimentType::direct_shear; }
bool triaxial(ExperimentType e) { return e == ExperimentType::triaxial; }

constexpr std::array<KeyUse, 14> kKeys{{
    {"width_mm", [](ExperimentType e) { return !disc(e); }, false, "only in compression and direct shear"},
    {"height_mm", compression, false, "only in compression"},
    {"diameter_mm", disc, false, "only of a Brazilian disc"},
    {"thickness_mm", disc, false, "only of a Brazilian disc"},
    {"confining_pressure_mpa", triaxial, true, "only in a triaxial test"},
    {"normal_stress_mpa", joint, true, "only in direct shear"},
    {"profile", joint, false, "only in direct shear"},
    {"end_gap_mm", joint, false, "only in direct shear"},
    {"shear_rate_mm_per_s", joint, false, "only in direct shear"},
    {"closing_rate_mm_per_s", [](ExperimentType e) { return !joint(e); }, false, "only between platens"},
    {"axial_gauge_mm", compression, false, "only in compression"},
    {"plane", compression, false, "only in compression"},
    {"core_angle_deg", [](ExperimentType e) { return !joint(e); }, false, "only in compression and of a disc"},
    {"lubricated_platens", compression, false, "only in compression"},
}};

/// Quantity and base of a feature's name.
struct Named {
  std::string base;
  Quantity quantity;
};

Named split_name(const FeatureKind& kind) {
  static const std::map<std::string_view, std::pair<std::string_view, Quantity>> units{
      {"MPa", {"_mpa", Quantity::stress}},
      {"GPa", {"_gpa", Quantity::modulus}},
      {"mm", {"_mm", Quantity::length}},
      {"N/mm", {"_n_per_mm", Quantity::line_load}}};
  const auto found = units.find(kind.unit);
  if (found == units.end()) {
    return {std::string(kind.name), kind.name.find("strain") != kind.name.npos ? Quantity::strain : Quantity::ratio};
  }
  const std::string_view suffix = found->second.first;
  return {std::string(kind.name.substr(0, kind.name.size() - suffix.size())), found->second.second};
}

struct KnownResult {
  std::string name;
  double factor;
};

/// The feature a result is, and the factor to its unit.
std::optional<KnownResult> known_result(const std::string& key, ExperimentType experiment) {
  for (const FeatureKind& kind : feature_kinds(experiment)) {
    const Named named = split_name(kind);
    if (const auto factor = unit_factor(key, named.base, named.quantity))
      return KnownResult{std::string(kind.name), *factor};
  }
  return std::nullopt;
}

Fault unknown_result(const std::string& key, const std::string& pointer, ExperimentType experiment) {
  std::vector<std::string> names;
  for (const FeatureKind& kind : feature_kinds(experiment)) {
    const Named named = split_name(kind);
    if (key.starts_with(named.base + "_") && named.quantity != Quantity::ratio) {
      return {pointer, "the unit of a result is not known", key, names_with_units(named.base, named.quantity),
              "convert it to one of these"};
    }
    names.emplace_back(kind.name);
  }
  const std::string near = closest(key, names);
  return {pointer, "is no result of this experiment", key, "names of its features",
          near.empty() ? "`asperity features` prints them, docs/measured_data.md lists them"
                       : "did you mean " + near + "?"};
}

/// One number, or a list of numbers and nulls; empty where it is neither.
std::vector<double> values_of(const json& given) {
  if (given.is_number()) return {given.get<double>()};
  std::vector<double> values;
  if (!given.is_array()) return values;
  for (const json& one : given) {
    if (!one.is_number() && !one.is_null()) return {};
    values.push_back(one.is_null() ? std::numeric_limits<double>::quiet_NaN() : one.get<double>());
  }
  return values;
}

std::vector<Fault> total_faults(const MeasuredTest& test, const std::string& pointer) {
  std::vector<Fault> faults;
  const auto peaks = test.results.find("peak_axial_stress_mpa");
  if (peaks == test.results.end() || !test.confining_pressure_mpa) return faults;
  for (const double peak : peaks->second) {
    if (std::isnan(peak) || peak > *test.confining_pressure_mpa) continue;
    faults.push_back({pointer + "/results/peak_axial_stress_mpa", "a peak is not above the confining pressure",
                      number_text(peak),
                      "total axial stress, above " + number_text(*test.confining_pressure_mpa) + " MPa",
                      "add the confining pressure to a stress difference; extension tests are not held"});
  }
  return faults;
}

}  // namespace

std::vector<Fault> key_faults(const json& test, const std::string& pointer, ExperimentType experiment) {
  std::vector<Fault> faults;
  const std::string type = "in a test of type \"" + std::string(word(experiment)) + "\"";
  for (const KeyUse& use : kKeys) {
    const bool given = test.contains(use.key), applies = use.applies(experiment);
    if (given && !applies) {
      faults.push_back(
          {pointer + "/" + use.key, "has no meaning " + type, json_text(test.at(use.key)), use.where, "remove it"});
    }
    if (!given && applies && use.required) {
      faults.push_back(
          {pointer + "/" + use.key, "is missing " + type, "", "above 0 MPa", "the test is loaded under it"});
    }
  }
  if (disc(experiment) && test.contains("curve") && !test.contains("diameter_mm")) {
    faults.push_back({pointer + "/diameter_mm", "is missing beside a disc's curve", "", "above 0 mm",
                      "the strength 2 P/(pi D t) needs it"});
  }
  if (!test.contains("curve") && test.value("results", json::object()).empty()) {
    faults.push_back({pointer, "has neither a curve nor results", "", "\"curve\", \"results\" or both", ""});
  }
  return faults;
}

std::vector<Fault> take_in_results(const json& given, const std::string& pointer, MeasuredTest& test) {
  std::vector<Fault> faults;
  std::size_t count = 0;
  if (!given.contains("results")) return faults;
  for (const auto& [key, value] : given.at("results").items()) {
    const std::string place = child_pointer(pointer + "/results", key);
    const auto known = known_result(key, test.experiment);
    if (!known) {
      faults.push_back(unknown_result(key, place, test.experiment));
      continue;
    }
    std::vector<double> values = values_of(value);
    if (values.empty()) {
      faults.push_back({place, "is no list of numbers", json_text(value), "a number for each specimen, or null", ""});
      continue;
    }
    if (count != 0 && values.size() != count) {
      faults.push_back({place, "has another number of specimens than the results before it",
                        std::to_string(values.size()), std::to_string(count),
                        "write null where a specimen has no value"});
    }
    count = std::max(count, values.size());
    for (double& v : values) v *= known->factor;
    if (!test.results.emplace(known->name, std::move(values)).second) {
      faults.push_back({place, "is given twice, in two units", key, "one of them", ""});
    }
  }
  return faults;
}

std::vector<Fault> test_faults(const MeasuredTest& test, const std::string& pointer) {
  std::vector<Fault> faults = total_faults(test, pointer);
  const std::size_t specimens = specimens_of(test).size();
  if (test.scatter == ScatterSource::specimens && specimens < 2) {
    faults.push_back({pointer + "/scatter", "asks for the scatter of specimens, and there is one",
                      std::to_string(specimens), "two specimens or more", "give the others, or say \"pooled\""});
  }
  return faults;
}

std::vector<Fault> id_faults(const MeasuredData& data) {
  std::vector<Fault> faults;
  std::map<std::string, std::size_t> seen;
  for (std::size_t i = 0; i < data.tests.size(); ++i) {
    const auto [first, fresh] = seen.emplace(data.tests[i].id, i);
    if (fresh) continue;
    faults.push_back({"/tests/" + std::to_string(i) + "/id", "is the name of two tests", data.tests[i].id,
                      "another than that of /tests/" + std::to_string(first->second), ""});
  }
  return faults;
}

}  // namespace asperity
