#include <cmath>
#include <filesystem>

#include "core/base/atomic_file.hpp"
#include "core/base/output_error.hpp"
#include "core/base/sha256.hpp"
#include "core/config/write_config.hpp"
#include "core/confrontation/confrontation_task.hpp"
#include "core/confrontation/final_run.hpp"

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

/// All that is decided before the data are looked at: features, library, levels, split.
ordered_json frozen(const ConfrontationConfig& config, const ConfrontationTask& task) {
  ordered_json json = {{"draws", task.options.draws.draws},
                       {"seed", task.options.draws.seed},
                       {"level", task.options.level},
                       {"near", task.options.near},
                       {"most", task.options.most},
                       {"explained_level", task.options.draws.explained_level},
                       {"misfit_level", task.options.draws.misfit_level},
                       {"least_ridge", task.options.draws.noise.least_ridge},
                       {"noise", task.plan.noise},
                       {"common", task.common},
                       {"screen", task.screen}};
  for (const TestEvidence& test : task.evidence.tests) {
    ordered_json slots = ordered_json::array();
    for (const FeatureSlot& s : test.slots) slots.push_back({s.kind->name, s.logarithmic, s.floor_sd});
    json["tests"][test.id] = {{"use", test.use == TestUse::fit ? "fit" : "hold_out"}, {"features", slots}};
  }
  for (const Candidate& c : task.evidence.candidates) json["library"][c.id] = {c.amplitude, c.two_sided};
  for (const ConfrontationParameter& p : config.parameters)
    json["parameters"][p.name] = {p.calibrated, p.step, p.lower, p.upper, p.reference};
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

/// The measured numbers alone: no name, material or source.
ordered_json data_numbers(const MeasuredData& data) {
  ordered_json json = ordered_json::object();
  for (const MeasuredTest& test : data.tests) {
    ordered_json entry = ordered_json::object();
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

}  // namespace

VerdictContext verdict_context(const ConfrontationConfig& config, const ConfrontationTask& task,
                               const Confrontation& confrontation) {
  VerdictContext context;
  const VectorXd coded = confrontation.centre + confrontation.base.coded;
  const std::vector<double> theta = theta_at(config, coded);
  Index c = 0;
  for (std::size_t p = 0; p < theta.size(); ++p) {
    const ConfrontationParameter& parameter = config.parameters[p];
    ParameterValue value{parameter.name, parameter.label, parameter.unit};
    value.value = value_of(parameter.transform, theta[p]);
    if (parameter.calibrated) {
      const double step = parameter.step * confrontation.base.error(c);
      value.error = 0.5 * std::abs(value_of(parameter.transform, theta[p] + step) -
                                   value_of(parameter.transform, theta[p] - step));
      value.determined = confrontation.base.determined[static_cast<std::size_t>(c)];
      value.limited = confrontation.base.limited[static_cast<std::size_t>(c)];
      ++c;
    }
    context.parameters.push_back(std::move(value));
  }
  if (config.split_proposed)
    context.notes.push_back(
        "the split into fitted and kept-back tests was proposed by kind of test: neither the "
        "measured file nor the configuration gives one");
  for (const std::string& name : config.idle_parameters)
    context.notes.push_back("parameter " + name + " acts in none of the tests and was left out");
  context.data_sha256 = sha256_hex(data_numbers(config.measured).dump());
  context.frozen_sha256 = sha256_hex(frozen(config, task).dump());
  return context;
}

std::string write_extended_configs(const ConfrontationConfig& config, const Confrontation& confrontation,
                                   const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder / "configs", error);
  if (error) throw output_error(folder / "configs", "cannot be created", error.value());
  std::string first;
  for (const MeasuredTest& test : config.measured.tests) {
    RunConfig run = final_run(config, confrontation, test, FinalModel::extension, VirtualOutput::as_base,
                              config.meshes.first_seed);
    run.name = config.name + "_" + test.id;
    const std::string path = "configs/" + run.name + ".json";
    write_file_atomically(folder / path, effective_json(run) + "\n");
    if (first.empty()) first = path;
  }
  return first;
}

}  // namespace asperity
