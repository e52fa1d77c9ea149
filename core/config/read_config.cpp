#include "core/config/read_config.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/config/bindings.hpp"
#include "core/config/cross_checks.hpp"
#include "core/config/json_text.hpp"
#include "core/config/measured_path.hpp"
#include "core/config/overrides.hpp"
#include "core/config/profile_csv.hpp"
#include "core/config/schema_faults.hpp"
#include "core/config/schema_lookup.hpp"

namespace asperity {

using nlohmann::json;

namespace {

[[noreturn]] void refuse_file(const std::filesystem::path& path, const std::string& reason) {
  throw Error(ErrorKind::config,
              {Fault{path.string(), "cannot be read: " + reason, "", "a JSON file", "check the path"}});
}

/// Adds the faults at places that have none yet: the first one named is the cause.
void append_new(std::vector<Fault>& faults, std::vector<Fault> more) {
  for (Fault& fault : more) {
    const auto same_place = [&](const Fault& known) { return known.where == fault.where; };
    if (std::none_of(faults.begin(), faults.end(), same_place)) faults.push_back(std::move(fault));
  }
}

KeyNotes notes_of(const json& document, const std::vector<Fault>& faults) {
  KeyNotes notes;
  for (const Fault& fault : faults) notes.faulty.insert(fault.where);
  for (const Binding& binding : bindings()) {
    const std::string pointer(binding.pointer);
    if (document.contains(json::json_pointer(pointer))) notes.given.insert(pointer);
  }
  return notes;
}

bool is_faulty(std::string_view pointer, const KeyNotes& notes) {
  return std::any_of(notes.faulty.begin(), notes.faulty.end(),
                     [&](const std::string& faulty) { return pointers_overlap(pointer, faulty); });
}

/// A name that is a good folder name, from a file's name.
std::string name_from(const std::string& origin) {
  std::string name = std::filesystem::path(origin).stem().string();
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '.' && c != '-') c = '_';
  const bool usable = !name.empty() && std::isalnum(static_cast<unsigned char>(name.front()));
  return usable ? name : RunConfig{}.name;
}

/// Fills the members of every key that is given and has no fault; the defaults that depend on other keys come last.
RunConfig fill(const json& document, const std::string& origin, const KeyNotes& notes) {
  RunConfig config;
  config.name = name_from(origin);
  for (const Binding& binding : bindings()) {
    const std::string pointer(binding.pointer);
    if (notes.given.contains(pointer) && !is_faulty(pointer, notes))
      binding.read(config, document.at(json::json_pointer(pointer)));
  }
  const bool strain = config.experiment.type != ExperimentType::brazilian;
  if (strain && !notes.given.contains("/experiment/plane")) config.experiment.plane = PlaneCondition::strain;
  return config;
}

/// A document that is no object has no keys to check further.
Fault not_an_object(const json& document, const std::string& origin) {
  return {origin, "must be an object", json_text(document), "{ \"experiment\": {...}, ... }", ""};
}

}  // namespace

std::string read_config_text(const std::filesystem::path& path) {
  std::error_code ignored;  // what is wrong with the path shows when it is opened
  if (std::filesystem::is_directory(path, ignored)) refuse_file(path, "it is a folder");
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse_file(path, std::strerror(errno));
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (file.bad()) refuse_file(path, "reading failed");
  return text;
}

std::string config_kind(const std::filesystem::path& path) {
  const json document = parse_json(read_config_text(path), path.string()).document;
  const bool named = document.is_object() && document.contains("$schema") && document.at("$schema").is_string();
  const std::string ending = ".schema.json";
  const std::string name =
      named ? std::filesystem::path(document.at("$schema").get<std::string>()).filename().string() : "";
  if (name.ends_with(ending)) return name.substr(0, name.size() - ending.size());
  if (document.is_object() && document.contains("measured") && document.contains("bases")) return "confrontation";
  return document.is_object() && document.contains("tests") && !document.contains("experiment") ? "measured" : "run";
}

RunConfig parse_run_config(const std::string& text, const std::string& origin,
                           const std::vector<std::string>& override_texts) {
  const std::vector<Override> overrides = parse_overrides(override_texts);
  const json& schema = parsed_schema("run");
  ParsedText parsed = parse_json(text, origin);
  std::vector<Fault> faults = std::move(parsed.faults);
  const bool checkable = parsed.well_formed && parsed.document.is_object();
  if (parsed.well_formed && !checkable) faults.push_back(not_an_object(parsed.document, origin));
  json document = checkable ? std::move(parsed.document) : json::object();
  append_new(faults, apply_overrides(document, schema, overrides));
  if (!checkable) throw Error(ErrorKind::config, std::move(faults));
  append_new(faults, schema_faults(document, schema));
  append_new(faults, take_in_profile(document, std::filesystem::path(origin).parent_path()));
  append_new(faults, take_in_measured_curve(document, std::filesystem::path(origin).parent_path()));
  const KeyNotes notes = notes_of(document, faults);
  const RunConfig config = fill(document, origin, notes);
  append_new(faults, cross_check(config, notes));
  if (!faults.empty()) throw Error(ErrorKind::config, std::move(faults));
  return config;
}

RunConfig read_run_config(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  parse_overrides(overrides);  // a malformed override is a usage error even if the file cannot be read
  return parse_run_config(read_config_text(path), path.string(), overrides);
}

}  // namespace asperity
