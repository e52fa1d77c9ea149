#include "core/confrontation/test_checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/config/enum_words.hpp"
#include "core/config/schema_lookup.hpp"

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

std::vector<Fault> test_faults(const MeasuredTest& test, const std::string& pointer) {
  std::vector<Fault> faults = total_faults(test, pointer);
  if (is_compression(test.experiment) && test.axial_gauge_mm && test.height_mm &&
      *test.axial_gauge_mm > *test.height_mm) {
    faults.push_back({pointer + "/axial_gauge_mm", "the gauge is longer than the specimen",
                      number_text(*test.axial_gauge_mm), "at most height_mm " + number_text(*test.height_mm) + " mm",
                      "a gauge between the platens is none: leave the key out"});
  }
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
