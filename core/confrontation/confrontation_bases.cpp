#include <algorithm>
#include <map>

#include "core/config/applicability.hpp"
#include "core/config/enum_words.hpp"
#include "core/config/json_text.hpp"
#include "core/config/read_config.hpp"
#include "core/config/schema_faults.hpp"
#include "core/config/schema_lookup.hpp"
#include "core/confrontation/confrontation_parts.hpp"
#include "core/confrontation/virtual_test.hpp"

namespace asperity::confrontation_parts {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

/// A base as the file has it, and the words by which its faults are placed.
struct GivenBase {
  ConfrontationBase base;
  std::string where;  ///< Before a pointer: "/bases/uniaxial", or that with a file's path.
};

void append(std::vector<Fault>& faults, std::vector<Fault> more, const std::string& prefix) {
  for (Fault& fault : more) {
    fault.where = prefix + fault.where;
    faults.push_back(std::move(fault));
  }
}

/// The base of a file.
GivenBase base_of_file(const std::string& where, const fs::path& path, std::vector<Fault>& faults) {
  GivenBase given{{json::object(), path}, where + ", " + path.string() + ": "};
  try {
    ParsedText parsed = parse_json(read_config_text(path), path.string());
    append(faults, parsed.faults, where + ", ");
    if (parsed.document.is_object()) given.base.document = std::move(parsed.document);
  } catch (const Error& error) {
    append(faults, error.faults(), where + ", ");
  }
  return given;
}

GivenBase given_base(const ConfrontationConfig& config, const std::string& key, std::vector<Fault>& faults) {
  const json& entry = config.document.at("bases").at(key);
  const std::string where = "/bases/" + key;
  if (entry.is_object()) return {{entry, config.path}, where};
  const fs::path path = entry.get<std::string>();
  return base_of_file(where, path.is_absolute() ? path : config.path.parent_path() / path, faults);
}

/// Drops the keys that a test of this type does not have, of a base that was written for another.
void turn_into(ConfrontationBase& base, ExperimentType type) {
  RunConfig probe;
  probe.experiment.type = type;
  base.document["experiment"]["type"] = word(type);
  for (const ConditionalKey& key : conditional_keys()) {
    const json::json_pointer pointer{std::string(key.pointer)};
    if (key.decided_by != "/experiment/type" || key.applies(probe) || !base.document.contains(pointer)) continue;
    base.document.at(pointer.parent_pointer()).erase(pointer.back());
  }
}

/// Of a uniaxial test the triaxial one's base may do, and the reverse.
std::optional<std::string> key_of(const json& bases, ExperimentType type) {
  const std::string own(word(type));
  if (bases.contains(own)) return own;
  const char* other = type == ExperimentType::uniaxial ? "triaxial" : "uniaxial";
  if (is_compression(type) && bases.contains(other)) return other;
  return std::nullopt;
}

void check_type(const GivenBase& given, const std::string& key, std::vector<Fault>& faults) {
  const std::string type = given.base.document.at("experiment").at("type");
  if (type == key) return;
  faults.push_back({given.where + "/experiment/type", "is another experiment's", "\"" + type + "\"", "\"" + key + "\"",
                    "move it to /bases/" + type});
}

void read_base(ConfrontationConfig& config, ExperimentType type, std::vector<Fault>& faults) {
  const std::optional<std::string> key = key_of(config.document.at("bases"), type);
  if (!key) {
    faults.push_back({"/bases/" + std::string(word(type)), "is missing: measured tests are of this experiment", "",
                      "a run configuration or its path", ""});
    return;
  }
  const std::size_t before = faults.size();
  GivenBase given = given_base(config, *key, faults);
  if (faults.size() == before) append(faults, schema_faults(given.base.document, parsed_schema("run")), given.where);
  if (faults.size() == before) check_type(given, *key, faults);
  if (faults.size() != before) return;
  if (*key != word(type)) turn_into(given.base, type);
  config.bases[type] = std::move(given.base);
}

/// Names of tests that lack a size, by its key.
using MissingSizes = std::map<std::string, std::vector<std::string>>;

void require_size(const MeasuredTest& test, const char* key, bool given, bool assumed, MissingSizes& missing) {
  if (!given && !assumed) missing[key].push_back(test.id);
}

bool gives_its_size(const MeasuredTest& t) {
  if (t.experiment == ExperimentType::brazilian) return t.diameter_mm.has_value();
  if (t.experiment == ExperimentType::direct_shear) return !t.profile.empty();
  return t.width_mm && t.height_mm;
}

void check_sizes(const MeasuredTest& test, const AssumedGeometry& assumed, MissingSizes& missing) {
  if (test.experiment == ExperimentType::brazilian) {
    require_size(test, "diameter_mm", test.diameter_mm.has_value(), assumed.diameter_mm.has_value(), missing);
  } else if (test.experiment == ExperimentType::direct_shear) {
    require_size(test, "profile", !test.profile.empty(), !assumed.profile.empty(), missing);
  } else {
    require_size(test, "width_mm", test.width_mm.has_value(), assumed.width_mm.has_value(), missing);
    require_size(test, "height_mm", test.height_mm.has_value(), assumed.height_mm.has_value(), missing);
  }
}

std::optional<double> number(const json& section, const char* key) {
  return section.contains(key) ? std::optional(section.at(key).get<double>()) : std::nullopt;
}

std::vector<ToothConfig> teeth_of(const json& section) {
  std::vector<ToothConfig> teeth;
  for (const json& tooth : section.value("profile", json::array())) {
    ToothConfig t;
    t.angle_deg = tooth.at("angle_deg").get<double>();
    t.height_mm = tooth.at("height_mm").get<double>();
    t.gap_before_mm = tooth.value("gap_before_mm", t.gap_before_mm);
    teeth.push_back(t);
  }
  return teeth;
}

}  // namespace

std::vector<ExperimentType> experiments_of(const MeasuredData& data) {
  std::vector<ExperimentType> all;
  for (const MeasuredTest& test : data.tests) all.push_back(test.experiment);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

void read_bases(ConfrontationConfig& config, std::vector<Fault>& faults) {
  std::vector<Fault> own;
  for (const ExperimentType type : experiments_of(config.measured)) read_base(config, type, own);
  for (Fault& fault : own) {  // a base that stands for two experiments has its faults once
    const auto same = [&](const Fault& f) { return f.where == fault.where && f.what == fault.what; };
    if (std::none_of(faults.begin(), faults.end(), same)) faults.push_back(std::move(fault));
  }
}

void read_assumed(ConfrontationConfig& config, std::vector<Fault>& faults) {
  const json section = config.document.value("assumed", json::object());
  AssumedGeometry& a = config.assumed;
  a.width_mm = number(section, "width_mm");
  a.height_mm = number(section, "height_mm");
  a.diameter_mm = number(section, "diameter_mm");
  a.end_gap_mm = number(section, "end_gap_mm");
  a.profile = teeth_of(section);
  a.why = section.value("why", "");
  bool used = false;
  MissingSizes missing;
  for (const MeasuredTest& test : config.measured.tests) {
    check_sizes(test, a, missing);
    used |= !gives_its_size(test);
  }
  for (const auto& [key, ids] : missing) {
    faults.push_back({"/assumed/" + key, "is missing, and the measured file does not give it for " + list_text(ids), "",
                      key == "profile" ? "the teeth of the joint" : "the size of the specimen in mm",
                      "add it to the measured file, or assume it here and say why"});
  }
  if (used && !section.empty() && a.why.empty())
    faults.push_back(
        {"/assumed/why", "is missing", "", "one sentence: why these sizes stand in for those not measured", ""});
}

std::vector<RunConfig> check_virtual_tests(const ConfrontationConfig& config, std::vector<Fault>& faults) {
  std::vector<RunConfig> tests;
  for (const MeasuredTest& test : config.measured.tests) {
    try {
      tests.push_back(virtual_test(config, test));
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::config) throw;
      append(faults, error.faults(), "");
    }
  }
  return tests;
}

}  // namespace asperity::confrontation_parts
