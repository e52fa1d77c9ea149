#include "core/calibration/simulated_config.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/sha256.hpp"
#include "core/base/units.hpp"
#include "core/calibration/config_sections.hpp"
#include "core/calibration/data_calibration.hpp"
#include "core/campaign/campaign_config.hpp"
#include "core/config/json_text.hpp"
#include "core/config/overrides.hpp"
#include "core/config/read_config.hpp"
#include "core/config/schema_faults.hpp"
#include "core/config/schema_lookup.hpp"

namespace asperity {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr const char* kModulus = "youngs_modulus_gpa";
constexpr const char* kRatio = "poissons_ratio";
constexpr const char* kStrength = "uniaxial_strength_mpa";
constexpr const char* kCohesion = "cohesion_mpa";
constexpr const char* kFriction = "friction_angle_deg";

void throw_if(const std::vector<Fault>& faults) {
  if (!faults.empty()) throw Error(ErrorKind::config, faults);
}

std::string hash_of(json document) {
  for (const char* elsewhere : {"$schema", "slurm"}) document.erase(elsewhere);
  return sha256_hex(document.dump());
}

json read_document(const fs::path& path, const std::vector<std::string>& overrides) {
  ParsedText parsed = parse_json(read_config_text(path), path.string());
  throw_if(parsed.faults);
  std::vector<Fault> faults =
      apply_overrides(parsed.document, parsed_schema("calibration"), parse_overrides(overrides));
  const std::vector<Fault> more = schema_faults(parsed.document, parsed_schema("calibration"));
  faults.insert(faults.end(), more.begin(), more.end());
  throw_if(faults);
  return parsed.document;
}

/// "/json/pointer=value" of each entry of an object of pointers.
std::vector<std::string> override_texts(const json& section) {
  std::vector<std::string> texts;
  for (const auto& [pointer, value] : section.items()) texts.push_back(pointer + "=" + value.dump());
  return texts;
}

/// What the file sets for one type of test, after what it sets for all.
std::vector<std::string> overrides_of(const json& document, ExperimentType type) {
  std::vector<std::string> texts = override_texts(document.value("set", json::object()));
  const char* key = type == ExperimentType::brazilian ? "set_disc" : "set_compression";
  for (const std::string& text : override_texts(document.value(key, json::object()))) texts.push_back(text);
  return texts;
}

SuiteTest read_test(const json& document, const fs::path& path) {
  SuiteTest test{path, read_config_text(path), {}, {}};
  const ExperimentType type = parse_run_config(test.text, path.string()).experiment.type;
  test.overrides = overrides_of(document, type);
  test.config = parse_run_config(test.text, path.string(), test.overrides);
  return test;
}

std::size_t count(const TestSuite& suite, ExperimentType type) {
  return static_cast<std::size_t>(std::count_if(suite.tests.begin(), suite.tests.end(), [&](const SuiteTest& test) {
    return test.config.experiment.type == type;
  }));
}

void read_suite(SimulatedCalibration& c, const json& document, const fs::path& folder, std::vector<Fault>& faults) {
  for (const json& entry : document.at("tests")) {
    try {
      c.suite.tests.push_back(read_test(document, folder / entry.get<std::string>()));
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::config) throw;
      for (Fault fault : error.faults()) {
        fault.where = "/tests, " + entry.get<std::string>() + ": " + fault.where;
        faults.push_back(std::move(fault));
      }
    }
  }
  throw_if(faults);
  const std::string list = document.at("tests").dump();
  if (count(c.suite, ExperimentType::direct_shear) > 0)
    faults.push_back({"/tests", "has a direct shear test, which is predicted and not calibrated to", list,
                      "Brazilian, uniaxial and triaxial tests", "remove it"});
  if (count(c.suite, ExperimentType::uniaxial) != 1)
    faults.push_back({"/tests", "must have one uniaxial test, for E, nu and the uniaxial strength", list, "", ""});
  if (find_target(c.targets, "tensile_strength_mpa") && count(c.suite, ExperimentType::brazilian) != 1)
    faults.push_back({"/tests", "must have one Brazilian test for the target tensile_strength_mpa", list, "", ""});
  const bool line = find_target(c.targets, kCohesion) || find_target(c.targets, kFriction);
  if (line && count(c.suite, ExperimentType::triaxial) < 1)
    faults.push_back({"/tests", "must have a triaxial test for the targets cohesion_mpa and friction_angle_deg", list,
                      "one confining pressure or more", ""});
}

/// A factor must be a number of the run configuration.
void check_factor(const Factor& factor, std::size_t i, std::vector<Fault>& faults) {
  const std::string where = "/factors/" + std::to_string(i) + "/pointer";
  const json& schema = parsed_schema("run");
  const json* node = factor.pointer.starts_with("/") ? schema_at(schema, factor.pointer) : nullptr;
  if (!node) {
    const std::size_t slash = factor.pointer.rfind('/');
    const std::string parent = slash == std::string::npos ? "" : factor.pointer.substr(0, slash);
    const std::string key = slash == std::string::npos ? factor.pointer : factor.pointer.substr(slash + 1);
    faults.push_back({where, "is no microparameter of the model", factor.pointer,
                      "the JSON pointer of a number in a run configuration, e.g. /contacts/cohesion_mpa",
                      key_hint(schema, parent, key)});
  } else if (node->value("type", "") != "number") {
    faults.push_back(
        {where, "is no number that could be varied", factor.pointer, "a number of a run configuration", ""});
  }
  if (factor.lower && factor.upper && *factor.lower >= *factor.upper) {
    faults.push_back({"/factors/" + std::to_string(i) + "/lower", "does not lie below upper",
                      number_text(*factor.lower), "below " + number_text(*factor.upper), "exchange lower and upper"});
  }
}

/// Eq. (V1) against the uniaxial strength given.
void check_contradiction(const std::vector<Target>& targets, double tolerance, std::vector<Fault>& faults) {
  const Target *c = find_target(targets, kCohesion), *phi = find_target(targets, kFriction),
               *strength = find_target(targets, kStrength);
  if (!c || !phi || !strength) return;
  const double implied = mohr_coulomb_strength(c->value, phi->value);
  if (std::abs(strength->value / implied - 1.0) <= tolerance) return;
  faults.push_back(
      {"/targets/uniaxial_strength_mpa/value", "contradicts cohesion and friction angle", number_text(strength->value),
       "within " + number_text(100.0 * tolerance) + " % of 2 C tan(45 deg + phi/2) = " + number_text(implied),
       "correct one of the three, or raise /contradiction_tolerance if the laboratory's line misses its "
       "uniaxial tests so far"});
}

void check_targets(const std::vector<Target>& targets, std::vector<Fault>& faults) {
  const auto missing = [&](const char* property, const char* why) {
    if (find_target(targets, property)) return;
    faults.push_back({"/targets", std::string(property) + " is missing", "", why, "add it to the targets"});
  };
  missing(kModulus, "needed for the elastic compensation");
  missing(kRatio, "needed for the elastic compensation");
  const bool line = find_target(targets, kCohesion) && find_target(targets, kFriction);
  if (!find_target(targets, kStrength) && !line)
    faults.push_back({"/targets", "no compressive strength is given", "",
                      "uniaxial_strength_mpa, or cohesion_mpa and friction_angle_deg", "add it to the targets"});
  for (const Target& t : targets) {
    const bool angle = t.property != kFriction || (t.value > 0.0 && t.value < 90.0);
    const bool ratio = t.property != kRatio || (t.value > 0.0 && t.value < 0.5);
    if (t.value > 0.0 && angle && ratio) continue;
    faults.push_back({"/targets/" + t.property + "/value", "is no possible value", number_text(t.value),
                      "above 0 (a friction angle below 90, Poisson's ratio below 0.5)", ""});
  }
}

void read_elastic(SimulatedCalibration& c, const json& document) {
  const json section = document.value("elastic", json::object());
  ElasticTask& task = c.elastic;
  task.stiffness.rule =
      section.value("stiffness", "multiple") == "closed_form" ? StiffnessRule::closed_form : StiffnessRule::multiple;
  task.stiffness.multiple = section.value("multiple", task.stiffness.multiple);
  task.ratio = section.value("ratio", "floats") == "fixed" ? RatioPolicy::fixed : RatioPolicy::floats;
  task.reading = section.value("reading", "window") == "initial" ? ElasticReading::initial : ElasticReading::window;
  task.tolerance = section.value("tolerance", task.tolerance);
  const std::size_t meshes = section.value("meshes", std::size_t{3});
  task.seeds.clear();
  for (std::size_t i = 0; i < meshes; ++i) task.seeds.push_back(c.first_seed + i);
  const auto value = [&](const char* property) {
    const Target* target = find_target(c.targets, property);
    return target ? target->value : 0.0;
  };
  task.target = {value(kModulus), value(kRatio), value(kStrength)};
  if (task.target.uniaxial_strength_mpa == 0.0)
    task.target.uniaxial_strength_mpa = mohr_coulomb_strength(value(kCohesion), value(kFriction));
}

void read_plan(SimulatedCalibration& c, const json& document) {
  const json design = document.value("design", json::object()),
             refinement = document.value("refinement", json::object()),
             verification = document.value("verification", json::object());
  c.star = design.value("alpha", "rotatable") == "spherical" ? StarDistance::spherical : StarDistance::rotatable;
  c.centre_points = design.value("centre_points", c.centre_points);
  c.first_seed = design.value("first_seed", c.first_seed);
  c.most_rounds = design.value("most_rounds", c.most_rounds);
  c.refinement.batch = refinement.value("meshes", c.refinement.batch);
  c.refinement.most_steps = refinement.value("most_steps", c.refinement.most_steps);
  c.verification.meshes = verification.value("meshes", c.verification.meshes);
  c.verification.trade_off_meshes = verification.value("trade_off_meshes", c.verification.trade_off_meshes);
  c.verification.first_seed = verification.value("first_seed", c.verification.first_seed);
}

void read_trade_off(SimulatedCalibration& c, const json& document) {
  for (const json& entry : document.value("trade_off", json::array())) {
    TradeOffSet set{entry.at("name"),
                    entry.at("why"),
                    override_texts(entry.value("set", json::object())),
                    override_texts(entry.value("set_disc", json::object())),
                    {}};
    const json parameters = entry.value("parameters", json::object());
    for (const auto& [pointer, value] : parameters.items()) set.parameters.emplace_back(pointer, value.get<double>());
    c.trade_off.push_back(std::move(set));
  }
}

}  // namespace

double mohr_coulomb_strength(double cohesion_mpa, double friction_angle_deg) {
  return 2.0 * cohesion_mpa * std::tan((45.0 + 0.5 * friction_angle_deg) * units::kRadPerDeg);
}

double mohr_coulomb_disc_strength(double uniaxial_strength_mpa, double friction_angle_deg) {
  const double slope = std::pow(std::tan((45.0 + 0.5 * friction_angle_deg) * units::kRadPerDeg), 2);
  return uniaxial_strength_mpa / (3.0 + slope);
}

const Target* find_target(const std::vector<Target>& targets, const std::string& property) {
  const auto found =
      std::find_if(targets.begin(), targets.end(), [&](const Target& target) { return target.property == property; });
  return found == targets.end() ? nullptr : &*found;
}

std::vector<Target> strength_targets(const std::vector<Target>& targets) {
  const bool line = find_target(targets, kCohesion) && find_target(targets, kFriction);
  std::vector<Target> strengths;
  for (const Target& target : targets) {
    if (target.property == kModulus || target.property == kRatio) continue;
    if (target.property == kStrength && line) continue;
    strengths.push_back(target);
  }
  return strengths;
}

bool is_data_calibration(const fs::path& path, const std::vector<std::string>& overrides) {
  return read_document(path, overrides).contains("data");
}

SimulatedCalibration read_simulated_calibration(const fs::path& path, const std::vector<std::string>& overrides) {
  const json document = read_document(path, overrides);
  const ordered_json ordered = document;
  std::vector<Fault> faults;
  SimulatedCalibration c;
  c.name = document.value("name", path.stem().string());
  c.description = document.value("description", "");
  c.config_hash = hash_of(document);
  c.targets = read_targets(ordered, faults);
  c.factors = read_factors(ordered, faults);
  c.analysis = read_analysis(ordered, faults);
  c.slurm = slurm_section(document);
  if (!document.contains("tests")) faults.push_back({"/tests", "is missing", "", "paths of run configurations", ""});
  throw_if(faults);
  check_targets(c.targets, faults);
  check_contradiction(c.targets, document.value("contradiction_tolerance", 0.1), faults);
  for (std::size_t i = 0; i < c.factors.size(); ++i) check_factor(c.factors[i], i, faults);
  throw_if(faults);
  check_design(central_composite(c.factors, c.star, 1));
  read_plan(c, document);
  read_elastic(c, document);
  read_trade_off(c, document);
  read_suite(c, document, path.parent_path(), faults);
  throw_if(faults);
  return c;
}

}  // namespace asperity
