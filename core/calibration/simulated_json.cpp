#include <algorithm>
#include <cmath>

#include "core/base/atomic_file.hpp"
#include "core/base/output_error.hpp"
#include "core/calibration/elastic_json.hpp"
#include "core/calibration/simulated_procedure.hpp"
#include "core/config/read_config.hpp"
#include "core/config/write_config.hpp"

namespace asperity {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

ordered_json settings_json(const ParameterSet& set) {
  ordered_json j = ordered_json::object();
  for (const auto& [pointer, value] : set.common) j[pointer] = value;
  const auto by_plane = [&](const char* name, const Settings& settings) {
    for (const auto& [pointer, value] : settings) j[pointer][name] = value;
  };
  by_plane("stress", set.stress);
  by_plane("strain", set.strain);
  return j;
}

ordered_json values_json(const std::vector<Factor>& factors, const std::vector<double>& values) {
  ordered_json j = ordered_json::object();
  for (std::size_t i = 0; i < values.size(); ++i) j[factors[i].pointer] = values[i];
  return j;
}

ordered_json route_json(const std::vector<Factor>& factors, const Route& route) {
  ordered_json j{{"parameters", parameters_json(factors, route.real)}};
  if (!route.sd.empty()) j["sd"] = values_json(factors, route.sd);
  j["runs"] = route.runs;
  j["misfit"] = route.misfit;
  return j;
}

ordered_json number(double value) { return std::isfinite(value) ? ordered_json(value) : ordered_json(); }

ordered_json steps_json(const std::vector<Factor>& factors, const Refinement& refinement) {
  ordered_json steps = ordered_json::array();
  for (const RefinementStep& step : refinement.steps) {
    ordered_json means = ordered_json::object();
    for (std::size_t i = 0; i < refinement.targets.size(); ++i)
      means[refinement.targets[i].property] = number(step.mean[i]);
    steps.push_back({{"parameters", parameters_json(factors, decode(factors, step.x))},
                     {"mean", means},
                     {"chi2", number(step.chi2)},
                     {"within_noise", step.within_noise},
                     {"within_tolerance", step.within_tolerance},
                     {"meshes", step.runs}});
  }
  return steps;
}

/// One figure of the failure mode over the meshes: mean and standard deviation of numbers, counts of words and
/// verdicts.
struct Figure {
  std::vector<double> numbers;
  std::vector<std::pair<std::string, int>> words;
  void count(const std::string& word) {
    for (auto& [w, n] : words) {
      if (w == word) return void(++n);
    }
    words.emplace_back(word, 1);
  }
};

ordered_json figure_json(const Figure& figure) {
  ordered_json j = ordered_json::object();
  if (figure.numbers.empty()) {
    for (const auto& [word, n] : figure.words) j[word] = n;
    return j;
  }
  const double n = static_cast<double>(figure.numbers.size());
  double mean = 0.0, square = 0.0;
  for (double v : figure.numbers) mean += v / n;
  for (double v : figure.numbers) square += (v - mean) * (v - mean);
  return {{"mean", mean}, {"sd", n > 1.0 ? ordered_json(std::sqrt(square / (n - 1.0))) : ordered_json()}, {"n", n}};
}

/// Leaves of nested objects by their dotted names.
void gather(std::vector<std::pair<std::string, Figure>>& figures, const std::string& name, const json& value) {
  if (value.is_object()) {
    for (const auto& [key, inner] : value.items()) gather(figures, name.empty() ? key : name + "." + key, inner);
    return;
  }
  if (value.is_null() || value.is_array()) return;
  auto found = std::find_if(figures.begin(), figures.end(), [&](const auto& f) { return f.first == name; });
  if (found == figures.end()) found = figures.insert(figures.end(), {name, {}});
  if (value.is_number()) {
    found->second.numbers.push_back(value.get<double>());
  } else {
    found->second.count(value.is_string() ? value.get<std::string>() : value.get<bool>() ? "yes" : "no");
  }
}

ordered_json failure_mode_json(const std::vector<CaseResult>& cases) {
  std::vector<std::pair<std::string, std::vector<std::pair<std::string, Figure>>>> tests;
  for (const CaseResult& c : cases) {
    for (const auto& [test, mode] : c.failure_modes) {
      auto found = std::find_if(tests.begin(), tests.end(), [&t = test](const auto& e) { return e.first == t; });
      if (found == tests.end()) found = tests.insert(tests.end(), {test, {}});
      gather(found->second, "", mode);
    }
  }
  ordered_json j = ordered_json::object();
  for (const auto& [test, figures] : tests) {
    for (const auto& [name, figure] : figures) j[test][name] = figure_json(figure);
  }
  return j;
}

ordered_json all_bad_runs(const SimulatedResult& result) {
  ordered_json list = ordered_json::array();
  for (std::size_t r = 0; r < result.rounds.size(); ++r) {
    for (ordered_json entry : bad_runs_json(result.rounds[r].responses.bad_runs)) {
      entry["round"] = r + 1;
      list.push_back(std::move(entry));
    }
  }
  return list;
}

ordered_json rounds_json(const SimulatedResult& result) {
  ordered_json list = ordered_json::array();
  for (const DesignRound& round : result.rounds) {
    const Analysis& a = round.analysis;
    const Solution& best = a.solutions.empty() ? a.compromise : a.solutions.front();
    list.push_back(round_json({round.design.factors, round.moved_by, best.point.desirability, a.solutions.size()}));
  }
  return list;
}

ordered_json solutions_json(const DesignRound& round, const std::vector<Target>& targets) {
  ordered_json list = ordered_json::array();
  for (const Solution& solution : round.analysis.solutions)
    list.push_back(solution_json(solution, round.design.factors, targets));
  return list;
}

ordered_json trade_off_json(const SimulatedResult& result) {
  ordered_json list = ordered_json::array();
  for (const VerifiedSet& set : result.trade_off) {
    list.push_back({{"name", set.name},
                    {"why", set.why},
                    {"parameters", settings_json(set.parameters)},
                    {"verification", verification_json(set.verification)},
                    {"failure_mode", failure_mode_json(set.cases)}});
  }
  return list;
}

}  // namespace

ordered_json calibration_json(const SimulatedCalibration& c, const SimulatedResult& result,
                              const std::vector<std::string>& configs, double wall_s) {
  const DesignRound& last = result.rounds.back();
  const std::vector<Factor>& factors = last.design.factors;
  const std::vector<Target> strengths = strength_targets(c.targets);
  ordered_json j{{"name", c.name}, {"kind", "simulated"}, {"targets", targets_json(c.targets)}};
  j["elastic"] = elastic_json(result.elastic.task, result.elastic.found, result.alternatives);
  j["design"] = design_json(last.design, last.seeds);
  j["responses"] = responses_json(last.responses);
  j["bad_runs"] = all_bad_runs(result);
  j["models"] = models_json(last.analysis.models, last.design.coded.size());
  j["rounds"] = rounds_json(result);
  j["solutions"] = solutions_json(last, strengths);
  j["compromise"] = solution_json(last.analysis.compromise, factors, strengths);
  j["routes"] = {{"quadratic", route_json(factors, result.quadratic)},
                 {"kriging", route_json(factors, result.kriging)}};
  j["routes"]["kriging"]["steps"] = steps_json(factors, result.refinement);
  j["chosen_route"] = result.chosen_route;
  j["parameters"] = settings_json(result.verified.parameters);
  j["configs"] = configs;
  j["verification"] = verification_json(result.verified.verification);
  j["failure_mode"] = failure_mode_json(result.verified.cases);
  j["trade_off"] = trade_off_json(result);
  j["cost"] = {{"runs", result.cost.runs},
               {"reused", result.cost.reused},
               {"wall_s", wall_s},
               {"compute_s", result.cost.compute_s}};
  j["warnings"] = result.warnings;
  return j;
}

std::vector<std::string> write_calibrated_configs(const SimulatedCalibration& c, const SimulatedResult& result,
                                                  const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder / "configs", error);
  if (error) throw output_error(folder / "configs", "cannot be created", error.value());
  std::vector<std::string> paths;
  for (const SuiteTest& test : c.suite.tests) {
    RunConfig config = configure(test, result.verified.parameters, test.config.particles.seed);
    config.output = parse_run_config(test.text, test.path.string()).output;  // a campaign's runs draw nothing
    config.description = "Made by the calibration " + c.name + ". " + config.description;
    paths.push_back("configs/" + test.path.stem().string() + ".json");
    write_file_atomically(folder / paths.back(), effective_json(config));
  }
  return paths;
}

}  // namespace asperity
