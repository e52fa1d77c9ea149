#include <cmath>
#include <filesystem>
#include <set>

#include "core/base/atomic_file.hpp"
#include "core/base/output_error.hpp"
#include "core/base/sha256.hpp"
#include "core/config/enum_words.hpp"
#include "core/config/mechanism_declaration.hpp"
#include "core/config/write_config.hpp"
#include "core/confrontation/confrontation_task.hpp"
#include "core/confrontation/feature_bank.hpp"
#include "core/confrontation/final_run.hpp"
#include "core/confrontation/known_confusions.hpp"
#include "core/confrontation/virtual_test.hpp"

/// What a confrontation leaves on record: hashes, parameters, the extended configuration.
namespace asperity {
namespace {

namespace fs = std::filesystem;
using Eigen::Index;
using Eigen::VectorXd;
using nlohmann::ordered_json;

ordered_json numbers(const std::vector<double>& values) {
  ordered_json list = ordered_json::array();
  for (const double v : values) list.push_back(std::isfinite(v) ? ordered_json(v) : ordered_json(nullptr));
  return list;
}

/// What amplitude 1 of a mechanism is.
ordered_json strong_values(const std::string& id) {
  ordered_json values = ordered_json::object();
  for (const MechanismParameter& p : find_mechanism(id)->parameters) values[p.key] = p.strong;
  return values;
}

const char* transform_word(ParameterTransform transform) {
  if (transform == ParameterTransform::tangent) return "tangent";
  return transform == ParameterTransform::log ? "log" : "linear";
}

/// All that is decided before the data are looked at: features, library, levels, split.
ordered_json frozen(const ConfrontationConfig& config, const ConfrontationTask& task) {
  ordered_json json = {{"draws", task.options.draws.draws},
                       {"seed", task.options.draws.seed},
                       {"level", task.options.level},
                       {"near", task.options.near},
                       {"most", task.options.most},
                       {"most_pairs", task.options.most_pairs},
                       {"linearise_at", task.linearised_at == LinearisedAt::reference ? "reference" : "calibrated"},
                       {"first_seed", task.plan.first_seed},
                       {"fresh_seed", task.plan.fresh_seed},
                       {"explained_level", task.options.draws.explained_level},
                       {"misfit_level", task.options.draws.misfit_level},
                       {"least_ridge", task.options.draws.noise.least_ridge},
                       {"apart", task.plan.apart},
                       {"noise", task.plan.noise},
                       {"fresh", task.plan.fresh},
                       {"common", task.common},
                       {"screen", task.screen}};
  for (const TestEvidence& test : task.evidence.tests) {
    ordered_json slots = ordered_json::array();
    for (const FeatureSlot& s : test.slots)
      slots.push_back({{"name", s.kind->name}, {"logarithmic", s.logarithmic}, {"floor_sd", s.floor_sd}});
    json["tests"][test.id] = {{"use", test.use == TestUse::fit ? "fit" : "hold_out"},
                              {"run", bank_key(virtual_test(config, *find_test(config.measured, test.id)))},
                              {"features", slots}};
  }
  for (const Candidate& c : task.evidence.candidates) {
    json["library"][c.id] = {{"run_at", c.amplitude},
                             {"far", c.far},
                             {"two_sided", c.two_sided},
                             {"least", c.least},
                             {"most", c.most},
                             {"whole", c.whole},
                             {"strong", strong_values(c.id)},
                             {"doubles", c.doubles},
                             {"tested_doubles", c.tested_doubles}};
  }
  for (const ConfrontationParameter& p : config.parameters) {
    ordered_json only = ordered_json::array();
    for (const ExperimentType type : p.only) only.push_back(word(type));
    json["parameters"][p.name] = {{"pointer", p.pointer},
                                  {"tied", p.tied},
                                  {"transform", transform_word(p.transform)},
                                  {"only", only},
                                  {"calibrated", p.calibrated},
                                  {"step", p.step},
                                  {"lower", p.lower},
                                  {"upper", p.upper},
                                  {"reference", p.reference}};
  }
  return json;
}

constexpr std::vector<double> Curve::*kColumns[] = {&Curve::path,
                                                    &Curve::load,
                                                    &Curve::gauge_strain,
                                                    &Curve::lateral_strain,
                                                    &Curve::dilation_mm,
                                                    &Curve::dilation_front_mm,
                                                    &Curve::dilation_rear_mm,
                                                    &Curve::events};

/// How a test was done and read: what changes its features or its virtual test.
ordered_json conditions(const MeasuredTest& test) {
  const Instrument& i = test.instrument;
  ordered_json teeth = ordered_json::array();
  for (const ToothConfig& t : test.profile) teeth.push_back({t.angle_deg, t.height_mm, t.gap_before_mm});
  return {
      {"experiment", word(test.experiment)},
      {"sizes_mm", numbers({test.width_mm.value_or(NAN), test.height_mm.value_or(NAN), test.diameter_mm.value_or(NAN),
                            test.thickness_mm.value_or(NAN)})},
      {"stresses_mpa", numbers({test.confining_pressure_mpa.value_or(NAN), test.normal_stress_mpa.value_or(NAN)})},
      {"joint", teeth},
      {"end_gap_mm", numbers({test.end_gap_mm.value_or(NAN)})},
      {"rates_mm_per_s", numbers({test.closing_rate_mm_per_s.value_or(NAN), test.shear_rate_mm_per_s.value_or(NAN)})},
      {"axial_gauge_mm", numbers({test.axial_gauge_mm.value_or(NAN)})},
      {"plane", test.plane ? ordered_json(word(*test.plane)) : ordered_json(nullptr)},
      {"core_angle_deg", test.preparation.core_angle_deg},
      {"lubricated_platens", test.preparation.lubricated_platens},
      {"scatter", test.scatter == ScatterSource::specimens ? "specimens" : "pooled"},
      {"ends_before_peak", test.ends_before_peak},
      {"instrument",
       numbers({i.load_noise_percent, i.displacement_noise_percent, i.transverse_noise_percent, i.load_scale_percent,
                i.displacement_scale_percent, i.load_zero_percent, i.displacement_zero_mm})}};
}

/// The measured numbers and their tests' conditions: no name, material or source.
ordered_json data_numbers(const MeasuredData& data) {
  ordered_json json = ordered_json::object();
  for (const MeasuredTest& test : data.tests) {
    ordered_json entry = conditions(test);
    for (const auto& [feature, values] : test.results) entry["results"][feature] = numbers(values);
    for (const SpecimenCurve& s : test.curves) {
      ordered_json columns = ordered_json::array();
      for (const std::vector<double> Curve::*column : kColumns) columns.push_back(numbers(s.curve.*column));
      entry["curves"].push_back(std::move(columns));
    }
    json[test.id] = std::move(entry);
  }
  return json;
}

/// All of the file's parameters in their own units; `error` is of the calibrated ones, in steps.
std::vector<ParameterValue> parameter_values(const ConfrontationConfig& config, const std::vector<double>& theta,
                                             const VectorXd& error) {
  std::vector<ParameterValue> values;
  Index c = 0;
  for (std::size_t p = 0; p < theta.size(); ++p) {
    const ConfrontationParameter& parameter = config.parameters[p];
    ParameterValue value{parameter.name, parameter.label, parameter.unit};
    value.value = value_of(parameter.transform, theta[p]);
    if (parameter.calibrated) {
      const double step = parameter.step * error(c++);
      value.error = 0.5 * std::abs(value_of(parameter.transform, theta[p] + step) -
                                   value_of(parameter.transform, theta[p] - step));
    }
    values.push_back(std::move(value));
  }
  return values;
}

std::vector<ParameterValue> base_parameters(const ConfrontationConfig& config, const Confrontation& confrontation) {
  const BaseFit& base = confrontation.base;
  std::vector<ParameterValue> values =
      parameter_values(config, theta_at(config, confrontation.centre + base.coded), base.error);
  std::size_t c = 0;
  for (std::size_t p = 0; p < values.size(); ++p) {
    if (!config.parameters[p].calibrated) continue;
    values[p].determined = base.determined[c];
    values[p].limited = base.limited[c++];
  }
  return values;
}

/// Of the best extension, as its configurations are written; only what calibration moves.
std::vector<ParameterValue> extended_parameters(const ConfrontationConfig& config, const Confrontation& confrontation) {
  const HypothesisFit& fit = confrontation.conclusion.kept.front();
  const VectorXd error = fit.covariance.diagonal().head(fit.coded.size()).array().sqrt();
  std::vector<ParameterValue> values =
      parameter_values(config, final_theta(config, confrontation, FinalModel::extension), error);
  std::vector<ParameterValue> moved;
  for (std::size_t p = 0; p < values.size(); ++p) {
    if (config.parameters[p].calibrated) moved.push_back(std::move(values[p]));
  }
  return moved;
}

std::string comma_list(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace

std::string frozen_record(const ConfrontationConfig& config, const ConfrontationTask& task) {
  return frozen(config, task).dump(1) + "\n";
}

VerdictContext verdict_context(const ConfrontationConfig& config, const ConfrontationTask& task,
                               const Confrontation& confrontation) {
  VerdictContext context;
  context.parameters = base_parameters(config, confrontation);
  if (!confrontation.conclusion.kept.empty()) context.extended_parameters = extended_parameters(config, confrontation);
  if (config.split_proposed)
    context.notes.push_back(
        "the split into fitted and kept-back tests was proposed by kind of test: neither the "
        "measured file nor the configuration gives one");
  for (const std::string& name : config.idle_parameters)
    context.notes.push_back("parameter " + name + " acts in none of the tests and was left out");
  if (!config.left_out_suspects.empty())
    context.notes.push_back("settings of the solver that were left out of the candidates and may be the cause: " +
                            comma_list(config.left_out_suspects));
  for (std::string& note : known_confusions(verdict_causes(confrontation), config.measured))
    context.notes.push_back(std::move(note));
  for (const HypothesisFit& fit : confrontation.conclusion.kept) {
    if (!fit.converged)
      context.notes.push_back("the refit of " + causes_text(confrontation, fit.causes) +
                              " did not converge: amplitude and misfit are its best run's, and a linear fit from "
                              "there still promises more; what counts is its gain on kept-back tests");
  }
  const VectorXd& specimens = confrontation.fitted.specimens;
  if (specimens.size() > 0 && (specimens.array() < 2.0).all())
    context.notes.push_back(
        "no fitted feature was measured on two specimens: how much the rock scatters is not known, and what meshes "
        "scatter stands in its place. If it scatters more, what is found or refuted here may be scatter");
  context.data_sha256 = sha256_hex(data_numbers(config.measured).dump());
  context.frozen_sha256 = sha256_hex(frozen_record(config, task));
  return context;
}

std::string confrontation_hash(const ConfrontationConfig& config) {
  nlohmann::json document = config.document;
  for (const char* elsewhere : {"$schema", "slurm", "bank"}) document.erase(elsewhere);
  ordered_json json{{"document", std::move(document)}, {"data", data_numbers(config.measured)}};
  for (const auto& [experiment, base] : config.bases) json["bases"].push_back(ordered_json(base.document));
  return sha256_hex(json.dump());
}

std::string write_extended_configs(const ConfrontationConfig& config, const Confrontation& confrontation,
                                   const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder / "configs", error);
  if (error) throw output_error(folder / "configs", "cannot be created", error.value());
  std::string first;
  std::set<std::string> taken;
  for (const MeasuredTest& test : config.measured.tests) {
    RunConfig run =
        final_run(config, confrontation, test, FinalModel::extension, VirtualOutput::as_base, config.meshes.first_seed);
    while (!taken.insert(run.name).second) run.name += "_";
    const std::string path = "configs/" + run.name + ".json";
    write_file_atomically(folder / path, effective_json(run) + "\n");
    if (first.empty()) first = path;
  }
  return first;
}

}  // namespace asperity
