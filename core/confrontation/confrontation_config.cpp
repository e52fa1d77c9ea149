#include "core/confrontation/confrontation_config.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "core/campaign/campaign_config.hpp"
#include "core/config/json_text.hpp"
#include "core/config/overrides.hpp"
#include "core/config/read_config.hpp"
#include "core/config/schema_faults.hpp"
#include "core/config/schema_lookup.hpp"
#include "core/confrontation/confrontation_parts.hpp"
#include "core/confrontation/feature_bank.hpp"
#include "core/confrontation/read_measured.hpp"

namespace asperity {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;
namespace parts = confrontation_parts;

void throw_if(const std::vector<Fault>& faults) {
  if (!faults.empty()) throw Error(ErrorKind::config, faults);
}

json read_document(const fs::path& path, const std::vector<std::string>& overrides) {
  const std::vector<Override> parsed_overrides = parse_overrides(overrides);
  ParsedText parsed = parse_json(read_config_text(path), path.string());
  throw_if(parsed.faults);
  if (!parsed.document.is_object())
    throw_if({{path.string(), "must be an object", json_text(parsed.document), "{ \"measured\": ..., ... }", ""}});
  std::vector<Fault> faults = apply_overrides(parsed.document, parsed_schema("confrontation"), parsed_overrides);
  for (Fault& fault : schema_faults(parsed.document, parsed_schema("confrontation")))
    faults.push_back(std::move(fault));
  throw_if(faults);
  return parsed.document;
}

/// Paths in the file are relative to it.
fs::path beside(const fs::path& file, const std::string& given) {
  return fs::path(given).is_absolute() ? fs::path(given) : (file.parent_path() / given).lexically_normal();
}

void read_declared(ConfrontationConfig& config) {
  for (const json& entry : config.document.value("declared", json::array()))
    config.declared.push_back({entry.at("what"), entry.at("value"), entry.at("why")});
}

void read_meshes(ConfrontationConfig& config, std::vector<Fault>& faults) {
  const json section = config.document.value("meshes", json::object());
  MeshCounts& m = config.meshes;
  m.noise = section.value("noise", m.noise);
  m.common = section.value("common", m.common);
  m.screen = section.value("screen", m.screen);
  m.fresh = section.value("fresh", m.fresh);
  m.first_seed = section.value("first_seed", m.first_seed);
  if (m.screen > m.common)
    faults.push_back({"/meshes/screen", "is more than common", std::to_string(m.screen),
                      "at most " + std::to_string(m.common), "they are the first ones of common"});
}

/// Faults of the measured file are told as that file's.
MeasuredData read_measured(const fs::path& path) {
  try {
    return read_measured_data(path);
  } catch (const Error& error) {
    std::vector<Fault> faults = error.faults();
    for (Fault& fault : faults) {
      if (fault.where.starts_with("/") && fault.where != path.string())
        fault.where = "/measured, " + path.string() + ": " + fault.where;
    }
    throw Error(error.kind(), std::move(faults));
  }
}

/// Reads the bank, so that a bad one is told before anything is made or replaced.
void check_bank(const ConfrontationConfig& config, std::vector<Fault>& faults) {
  if (!config.bank) return;
  if (!fs::exists(*config.bank)) {
    faults.push_back({"/bank", "is no file", config.bank->string(), "what --write-bank has written",
                      "leave it out to have every run computed"});
    return;
  }
  try {
    read_bank(*config.bank);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::config) throw;
    for (Fault fault : error.faults()) {
      fault.where = "/bank, " + fault.where;
      faults.push_back(std::move(fault));
    }
  }
}

ConfrontationConfig read_keys(const fs::path& path, json document) {
  ConfrontationConfig config;
  config.path = path;
  config.name = document.value("name", path.stem().string());
  config.description = document.value("description", "");
  config.measured_path = beside(path, document.at("measured").get<std::string>());
  config.linearise_at =
      document.value("linearise_at", "calibrated") == "reference" ? LineariseAt::reference : LineariseAt::calibrated;
  config.draws = document.value("draws", config.draws);
  config.alarm_level = document.value("alarm_level", config.alarm_level);
  config.seed = document.value("seed", config.seed);
  if (document.contains("bank")) config.bank = beside(path, document.at("bank").get<std::string>());
  config.slurm = slurm_section(document);
  config.document = std::move(document);
  return config;
}

}  // namespace

const MeasuredTest* find_test(const MeasuredData& data, const std::string& id) {
  const auto found =
      std::find_if(data.tests.begin(), data.tests.end(), [&](const MeasuredTest& t) { return t.id == id; });
  return found == data.tests.end() ? nullptr : &*found;
}

ConfrontationConfig read_confrontation(const fs::path& path, const std::vector<std::string>& overrides) {
  ConfrontationConfig config = read_keys(path, read_document(path, overrides));
  config.measured = read_measured(config.measured_path);
  std::vector<Fault> faults;
  check_bank(config, faults);
  read_declared(config);
  read_meshes(config, faults);
  parts::read_bases(config, faults);
  parts::read_assumed(config, faults);
  parts::read_sets(config, faults);
  parts::read_split(config, faults);
  parts::read_compared_features(config, faults);
  throw_if(faults);
  const std::vector<RunConfig> tests = parts::check_virtual_tests(config, faults);
  throw_if(faults);
  parts::read_parameters(config, tests, faults);
  parts::read_candidates(config, tests, faults);
  throw_if(faults);
  return config;
}

}  // namespace asperity
