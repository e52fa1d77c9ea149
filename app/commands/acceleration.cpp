#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cmath>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "app/commands/commands.hpp"
#include "app/exit_code.hpp"
#include "app/installation.hpp"
#include "app/interruption.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"
#include "core/config/read_config.hpp"
#include "core/experiment/run.hpp"
#include "core/measurement/results.hpp"

namespace asperity::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kTolerance = 0.02;       // of the reference's peak
constexpr double kElasticFraction = 0.8;  // of first softening
constexpr double kPerturbation = 1.01;    // of the reference's rate: far too little to matter but for chaos

/// One way to run a test; the first is the reference.
struct Way {
  std::string name;
  double rate_factor;  ///< Times the configuration's closing rate.
  bool rate_control, mass_scaling, elastic_start;
};

std::vector<Way> ways(double reference_rate_factor) {
  return {{"reference", reference_rate_factor, false, false, false},
          {"reference, rate 1 % off", kPerturbation * reference_rate_factor, false, false, false},
          {"configured rate", 1.0, false, false, false},
          {"rate control", 1.0, true, false, false},
          {"mass scaling", 1.0, false, true, false},
          {"elastic start", 1.0, false, false, true},
          {"all three", 1.0, true, true, true}};
}

/// What one run gave.
struct Outcome {
  double peak = NAN, modulus = NAN;
  double tension = NAN, shear = NAN;  ///< Contacts broken by the end of the test.
  double steps = NAN, compute_s = NAN, added_mass = NAN;
};

const char* text(bool value) { return value ? "true" : "false"; }

RunConfig configure(const std::filesystem::path& file, const Way& way, int seed) {
  const RunConfig plain = read_run_config(file, {});
  const double rate = way.rate_factor * plain.experiment.loading.closing_rate_mm_per_s;
  return read_run_config(
      file, {fmt::format("/particles/seed={}", seed), fmt::format("/experiment/loading/closing_rate_mm_per_s={}", rate),
             fmt::format("/experiment/loading/rate_control/enabled={}", text(way.rate_control)),
             fmt::format("/integration/mass_scaling/uniform={}", text(way.mass_scaling)),
             fmt::format("/experiment/loading/elastic_start_fraction={}", way.elastic_start ? kElasticFraction : 0.0)});
}

Outcome run_way(const std::filesystem::path& file, const Way& way, int seed) {
  const ParallelLoops loops;
  Model model = build_model(configure(file, way, seed), loops);
  RunState state = start_run(model);
  RunObserver observer;
  observer.interrupted = [] { return interruption_requested(); };
  const auto start = std::chrono::steady_clock::now();
  run_experiment(model, state, loops, observer);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  Outcome outcome;
  const Peak peak = find_peak(state.samples, model.config.measurement.peak_strain_limit);
  const Sample& last = state.samples.back();
  outcome.peak = peak.stress_mpa;
  if (model.config.experiment.type != ExperimentType::brazilian) {
    const auto moduli = fit_moduli(state.samples, peak, model.config);
    if (moduli) outcome.modulus = moduli->youngs_modulus_gpa;
  }
  outcome.tension = last.cracks_tension;
  outcome.shear = last.cracks_shear;
  outcome.steps = static_cast<double>(model.system.step);
  outcome.compute_s = passed.count();
  outcome.added_mass = model.added_mass_fraction;
  return outcome;
}

struct Statistics {
  double mean = 0, deviation = 0;
};

Statistics statistics(const std::vector<double>& values) {
  Statistics s;
  for (double v : values) s.mean += v / static_cast<double>(values.size());
  double square = 0.0;
  for (double v : values) square += (v - s.mean) * (v - s.mean);
  if (values.size() > 1) s.deviation = std::sqrt(square / static_cast<double>(values.size() - 1));
  return s;
}

using Outcomes = std::vector<std::vector<Outcome>>;  // [way][seed]

std::vector<double> column(const std::vector<Outcome>& outcomes, double Outcome::*member) {
  std::vector<double> values;
  for (const Outcome& o : outcomes) values.push_back(o.*member);
  return values;
}

/// Relative difference of each seed's figure from the same seed's reference.
std::vector<double> differences(const Outcomes& outcomes, std::size_t way, double Outcome::*member) {
  std::vector<double> values;
  for (std::size_t seed = 0; seed < outcomes[way].size(); ++seed) {
    values.push_back(outcomes[way][seed].*member / (outcomes[0][seed].*member) - 1.0);
  }
  return values;
}

std::string plus_minus(const Statistics& s, const char* format) {
  return fmt::format(fmt::runtime(std::string(format) + " ± " + format), s.mean, s.deviation);
}

std::string percent(const Statistics& s) { return fmt::format("{:+.2f} ± {:.2f}", 100 * s.mean, 100 * s.deviation); }

bool within_tolerance(const Outcomes& outcomes, std::size_t way) {
  return std::abs(statistics(differences(outcomes, way, &Outcome::peak)).mean) <= kTolerance;
}

std::string table_row(const Way& way, const Outcomes& outcomes, std::size_t w) {
  const auto mean = [&](double Outcome::*member) { return statistics(column(outcomes[w], member)); };
  const bool disc = std::isnan(outcomes[0][0].modulus);
  const double speed = statistics(column(outcomes[0], &Outcome::compute_s)).mean / mean(&Outcome::compute_s).mean;
  return fmt::format(
      "| {} | {} | {} | {} | {} | {} | {} | {:.0f} | {:.2f} | {:.1f} | {} |\n", way.name,
      plus_minus(mean(&Outcome::peak), "{:.3f}"), percent(statistics(differences(outcomes, w, &Outcome::peak))),
      disc ? "" : fmt::format("{:.4f}", mean(&Outcome::modulus).mean),
      disc ? "" : percent(statistics(differences(outcomes, w, &Outcome::modulus))),
      plus_minus(mean(&Outcome::tension), "{:.0f}"), plus_minus(mean(&Outcome::shear), "{:.0f}"),
      mean(&Outcome::steps).mean, mean(&Outcome::compute_s).mean, speed, within_tolerance(outcomes, w) ? "yes" : "no");
}

std::string markdown(const std::string& name, const std::vector<Way>& table, const Outcomes& outcomes) {
  std::string result = fmt::format(
      "{}, {} seeds\n\n| | peak [MPa] | to reference [%] | E [GPa] | to reference [%] | tension cracks | shear cracks "
      "| steps | compute [s] | times faster | peak within {:.0f} % |\n|---|---|---|---|---|---|---|---|---|---|---|\n",
      name, outcomes[0].size(), 100 * kTolerance);
  for (std::size_t w = 0; w < table.size(); ++w) result += table_row(table[w], outcomes, w);
  return result;
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json report(const std::vector<Way>& table, const Outcomes& outcomes) {
  Json rows = Json::array();
  for (std::size_t w = 0; w < table.size(); ++w) {
    Json row{{"way", table[w].name}, {"rate_factor", table[w].rate_factor}};
    const Statistics peak = statistics(differences(outcomes, w, &Outcome::peak));
    row["peak_difference"] = {{"mean", peak.mean}, {"sd", peak.deviation}};
    row["peak_within_tolerance"] = within_tolerance(outcomes, w);
    for (const Outcome& o : outcomes[w]) {
      row["runs"].push_back({{"peak_mpa", number(o.peak)},
                             {"youngs_modulus_gpa", number(o.modulus)},
                             {"cracks_tension", o.tension},
                             {"cracks_shear", o.shear},
                             {"steps", o.steps},
                             {"compute_s", o.compute_s},
                             {"added_mass_fraction", o.added_mass}});
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

int acceleration_command(const AccelerationOptions& options) {
  install_interruption_handlers();
  const std::vector<Way> table = ways(options.reference_rate_factor);
  Json json{{"tolerance", kTolerance}, {"elastic_start_fraction", kElasticFraction}};
  bool all_within = true;
  for (const std::filesystem::path& name : options.configs) {
    const std::filesystem::path file = shipped(name);
    Outcomes outcomes(table.size());
    for (int seed = 1; seed <= options.seeds; ++seed) {
      for (std::size_t w = 0; w < table.size(); ++w) {
        outcomes[w].push_back(run_way(file, table[w], seed));
        if (interruption_requested()) return 130;
        const Outcome& o = outcomes[w].back();
        std::cerr << fmt::format("{}, seed {}, {}: {:.4g} MPa, {:.0f} steps, {:.2f} s\n", file.stem().string(), seed,
                                 table[w].name, o.peak, o.steps, o.compute_s);
      }
    }
    for (std::size_t w = 2; w < table.size(); ++w) all_within = all_within && within_tolerance(outcomes, w);
    json["tests"][file.stem().string()] = report(table, outcomes);
    std::cout << markdown(file.stem().string(), table, outcomes) << std::endl;
  }
  if (options.json) write_file_atomically(*options.json, json.dump(2) + "\n");
  return all_within ? 0 : exit_code(ErrorKind::tolerance);
}

}  // namespace asperity::app
