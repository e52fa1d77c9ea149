#include "core/confrontation/virtual_test.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "core/config/cross_checks.hpp"
#include "core/config/enum_words.hpp"
#include "core/config/mechanism_declaration.hpp"
#include "core/config/read_config.hpp"
#include "core/config/schema_faults.hpp"
#include "core/config/schema_lookup.hpp"
#include "core/confrontation/config_numbers.hpp"
#include "core/confrontation/significant_digits.hpp"

namespace asperity {
namespace {

using nlohmann::json;

constexpr const char* kAxialGauge = "/measurement/axial_gauge_mm";
constexpr const char* kLateralGauge = "/measurement/lateral_gauge_mm";
constexpr int kDigits = 12;

json& at(json& document, const char* pointer) { return document[json::json_pointer(pointer)]; }

/// What the test gives, else what is assumed for it.
void take_size(json& document, const char* pointer, const std::optional<double>& given,
               const std::optional<double>& assumed) {
  if (given || assumed) at(document, pointer) = given ? *given : *assumed;
}

/// A gauge that is longer than the specimen shrinks to it.
void shorten_gauge(json& document, const char* pointer, double usual, double height) {
  const json& there = at(document, pointer);
  const double length = there.is_number() ? there.get<double>() : usual;
  at(document, pointer) = std::min(length, height);
}

void take_gauges(json& document, const MeasuredTest& test) {
  const json::json_pointer pointer("/experiment/height_mm");
  const double height = document.value(pointer, ExperimentConfig().height_mm);
  if (test.axial_gauge_mm) at(document, kAxialGauge) = *test.axial_gauge_mm;
  shorten_gauge(document, kAxialGauge, MeasurementConfig().axial_gauge_mm, height);
  shorten_gauge(document, kLateralGauge, MeasurementConfig().lateral_gauge_mm, height);
}

json teeth_json(const std::vector<ToothConfig>& teeth) {
  json list = json::array();
  for (const ToothConfig& t : teeth)
    list.push_back({{"angle_deg", t.angle_deg}, {"height_mm", t.height_mm}, {"gap_before_mm", t.gap_before_mm}});
  return list;
}

/// A joint's profile takes the place of whatever the base has.
void take_joint(json& document, const MeasuredTest& test, const AssumedGeometry& assumed) {
  const std::vector<ToothConfig>& teeth = test.profile.empty() ? assumed.profile : test.profile;
  json& joint = at(document, "/joint");
  for (const char* key : {"profile_csv", "points_mm"}) joint.erase(key);
  joint["profile"] = teeth_json(teeth);
  take_size(document, "/joint/end_gap_mm", test.end_gap_mm, assumed.end_gap_mm);
  at(document, "/experiment/normal_stress_mpa") = test.normal_stress_mpa.value();
}

void take_test(json& document, const MeasuredTest& test, const AssumedGeometry& assumed) {
  at(document, "/experiment/type") = word(test.experiment);
  if (test.experiment == ExperimentType::direct_shear) return take_joint(document, test, assumed);
  if (test.experiment == ExperimentType::brazilian)
    return take_size(document, "/experiment/diameter_mm", test.diameter_mm, assumed.diameter_mm);
  take_size(document, "/experiment/width_mm", test.width_mm, assumed.width_mm);
  take_size(document, "/experiment/height_mm", test.height_mm, assumed.height_mm);
  if (test.experiment == ExperimentType::triaxial)
    at(document, "/experiment/confining_pressure_mpa") = test.confining_pressure_mpa.value();
  take_gauges(document, test);
}

void add_overrides(std::vector<std::string>& texts, const json& set) {
  for (const auto& [pointer, value] : set.items()) texts.push_back(pointer + "=" + value.dump());
}

std::vector<std::string> overrides_of(const ConfrontationConfig& config, const MeasuredTest& test) {
  std::vector<std::string> texts;
  add_overrides(texts, config.set);
  const auto own = config.test_set.find(test.id);
  if (own != config.test_set.end()) add_overrides(texts, own->second);
  return texts;
}

[[noreturn]] void throw_with_prefix(const Error& error, const std::string& prefix) {
  std::vector<Fault> faults = error.faults();
  for (Fault& fault : faults) fault.where = prefix + fault.where;
  throw Error(ErrorKind::config, std::move(faults));
}

/// Letters, digits, point, dash and underscore.
std::string run_name(const std::string& name, const std::string& id) {
  std::string text = name + "_" + id;
  for (char& c : text) {
    const bool good = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (!good && c != '.' && c != '-') c = '_';
  }
  return text.substr(0, 100);
}

/// Pictures change no feature, and their settings would make other runs of the same ones.
void reduce_output(OutputConfig& output) {
  const double interval = output.checkpoint_interval_s;
  output = OutputConfig();
  output.frames = 0;
  output.fields = {"cracks"};
  output.checkpoint_interval_s = interval;
}

RunConfig parsed(const ConfrontationConfig& config, const ConfrontationBase& base, const json& document,
                 const MeasuredTest& test) {
  const std::string prefix = "virtual test " + test.id + ": ";
  try {
    const RunConfig run = parse_run_config(document.dump(), base.origin.string(), overrides_of(config, test));
    if (run.experiment.type == test.experiment) return run;
    throw Error(ErrorKind::config,
                {{"/experiment/type", "is not the measured test's", std::string(word(run.experiment.type)),
                  std::string(word(test.experiment)), "leave it out of \"set\""}});
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::config) throw;
    throw_with_prefix(error, prefix);
  }
}

/// The schema's range of a key that a parameter has moved.
void check_range(const std::string& pointer, double value, std::vector<Fault>& faults) {
  const json* node = schema_at(parsed_schema("run"), pointer);
  for (Fault fault : schema_faults(json(value), *node)) {
    fault.where = pointer;
    faults.push_back(std::move(fault));
  }
}

void set_checked(RunConfig& run, const std::string& pointer, double value, std::vector<Fault>& faults) {
  set_number(run, pointer, value);
  check_range(pointer, value, faults);
}

void move_parameter(RunConfig& run, const ConfrontationParameter& parameter, double theta, std::vector<Fault>& faults) {
  const double value = value_of(parameter.transform, theta);
  set_checked(run, parameter.pointer, value, faults);
  for (const std::string& tied : parameter.tied) {
    const double before = number_of(run, tied).value();
    set_checked(run, tied, rounded_to(before * (value / parameter.reference), kDigits), faults);
  }
}

/// A setting that is off to the other side of its strong value: files have no amplitude below 0, so they state values.
MechanismConfig as_a_file_states(const MechanismConfig& m) {
  if (m.amplitude.value_or(0.0) >= 0.0) return m;
  MechanismConfig stated{m.type, std::nullopt, mechanism_values(*find_mechanism(m.type), m)};
  for (auto& [key, value] : stated.parameters) value = rounded_to(value, kDigits);
  return stated;
}

}  // namespace

RunConfig virtual_test(const ConfrontationConfig& config, const MeasuredTest& test, VirtualOutput output) {
  const ConfrontationBase& base = config.bases.at(test.experiment);
  json document = base.document;
  take_test(document, test, config.assumed);
  RunConfig run = parsed(config, base, document, test);
  run.name = run_name(config.name, test.id);
  run.description = "Virtual test " + test.id + " of " + config.measured.name + ".";
  run.mechanisms = acting_in(test.preparation, run.mechanisms);
  if (output == VirtualOutput::least) reduce_output(run.output);
  return run;
}

RunConfig configured(const RunConfig& virtual_test, const std::vector<ConfrontationParameter>& parameters,
                     const std::vector<double>& theta, const std::vector<MechanismConfig>& mechanisms,
                     std::uint64_t seed) {
  RunConfig run = virtual_test;
  std::vector<Fault> faults;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (acts_in(parameters[i], run.experiment.type)) move_parameter(run, parameters[i], theta.at(i), faults);
  }
  for (const MechanismConfig& m : mechanisms) run.mechanisms.push_back(as_a_file_states(m));
  run.particles.seed = seed;
  for (Fault& fault : cross_check(run)) faults.push_back(std::move(fault));
  if (!faults.empty()) throw_with_prefix(Error(ErrorKind::config, std::move(faults)), run.name + ": ");
  return run;
}

std::optional<RunConfig> configured_if_legal(const RunConfig& virtual_test,
                                             const std::vector<ConfrontationParameter>& parameters,
                                             const std::vector<double>& theta,
                                             const std::vector<MechanismConfig>& mechanisms, std::uint64_t seed) {
  try {
    return configured(virtual_test, parameters, theta, mechanisms, seed);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::config) throw;
    return std::nullopt;
  }
}

bool can_act(const RunConfig& virtual_test, const std::string& mechanism) {
  RunConfig run = virtual_test;
  run.mechanisms.push_back({mechanism, std::nullopt, {}});
  return mechanism_faults(run).empty();
}

bool can_act(const MeasuredTest& test, const RunConfig& virtual_test, const std::string& mechanism) {
  return acting_in(test.preparation, {mechanism, std::nullopt, {}}) && can_act(virtual_test, mechanism);
}

}  // namespace asperity
