#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <mutex>
#include <thread>

#include "app/commands/commands.hpp"
#include "app/installation.hpp"
#include "app/interruption.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"
#include "core/config/read_config.hpp"
#include "core/experiment/run.hpp"
#include "core/measurement/results.hpp"

namespace asperity::app {
namespace {

/// One reading of the law, and the figures an earlier study of this model gave for it ("-" where it gave none).
struct Row {
  std::string name;
  std::vector<std::string> overrides;
  double strain_limit;  ///< Compression: the peak is looked for up to this strain, before friction hardens.
  std::array<std::string, 6> before;  ///< In the order of kQuantities.
};

constexpr std::array<const char*, 6> kQuantities{"sigma_t [MPa]", "sigma_c [MPa]", "C [MPa]",
                                                 "phi [deg]",     "E [GPa]",       "nu [-]"};

std::vector<Row> rows() {
  const std::string literal = "/contacts/law/reading=literal", coulomb = "/contacts/law/shear_peak=coulomb";
  const std::string k_s = "/contacts/law/opening_shear_stiffness=k_s", weak = "/contacts/cohesion_mpa=1.65";
  return {{"literal", {literal}, 0.02, {"2.25 +- 0.16", "10.6 +- 0.1", "4.93 +- 0.11", "4.2 +- 0.9", "0.79", "0.23"}},
          {"literal, Coulomb peak",
           {literal, coulomb},
           0.045,
           {"2.95 +- 0.02", "20.5", "5.49", "33.7 +- 2.5", "0.79", "0.23"}},
          {"literal, Coulomb peak, c_c = 1.65",
           {literal, coulomb, weak},
           0.02,
           {"1.38 +- 0.04", "6.98 +- 0.17", "1.76 +- 0.04", "36.7 +- 1.1", "0.79", "0.23"}},
          {"literal, Coulomb peak, k_s on both sides, c_c = 1.65",
           {literal, coulomb, k_s, weak},
           0.02,
           {"0.96 +- 0.01", "6.84 +- 0.24", "1.71 +- 0.07", "36.6 +- 0.2", "0.73", "0.24"}},
          {"default law", {}, 0.045, {"-", "-", "-", "-", "-", "-"}},
          {"default law, c_c = 1.65", {weak}, 0.02, {"-", "-", "-", "-", "-", "-"}}};
}

std::vector<Row> chosen_rows(const std::vector<int>& numbers) {
  const std::vector<Row> all = rows();
  if (numbers.empty()) return all;
  std::vector<Row> chosen;
  for (int number : numbers) chosen.push_back(all.at(number - 1));
  return chosen;
}

/// What one run of one row gave.
struct Outcome {
  double peak = NAN, modulus = NAN, ratio = NAN;
  std::string failure;
};

constexpr std::array<const char*, 4> kTests{"brazilian", "uniaxial", "triaxial_0.5", "triaxial_1.0"};
constexpr std::array<double, 3> kConfining{0.0, 0.5, 1.0};

Outcome run_test(const std::filesystem::path& config_file, const std::vector<std::string>& overrides) {
  Outcome outcome;
  try {
    const ParallelLoops loops;
    Model model = build_model(read_run_config(config_file, overrides), loops);
    RunState state = start_run(model);
    RunObserver observer;
    observer.interrupted = [] { return interruption_requested(); };
    run_experiment(model, state, loops, observer);
    if (state.stop == StopReason::interrupted) return {NAN, NAN, NAN, "interrupted"};
    const Peak peak = find_peak(state.samples, model.config.measurement.peak_strain_limit);
    outcome.peak = peak.stress_mpa;
    if (model.config.experiment.type == ExperimentType::brazilian) return outcome;
    if (const auto moduli = fit_moduli(state.samples, peak, model.config)) {
      outcome.modulus = moduli->youngs_modulus_gpa;
      outcome.ratio = moduli->poissons_ratio;
    }
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::config) throw;
    outcome.failure = error.what();
  }
  return outcome;
}

std::string mean_and_deviation(const std::vector<double>& values) {
  double mean = 0, square = 0;
  for (double v : values) mean += v / static_cast<double>(values.size());
  for (double v : values) square += (v - mean) * (v - mean);
  if (values.size() < 2) return fmt::format("{:.3g}", mean);
  return fmt::format("{:.3g} +- {:.2g}", mean, std::sqrt(square / static_cast<double>(values.size() - 1)));
}

/// The six quantities of a row from its runs, [seed][test].
std::array<std::string, 6> evaluate(const std::vector<std::array<Outcome, 4>>& runs) {
  std::array<std::vector<double>, 6> values;
  for (const auto& run : runs) {
    const std::array<double, 3> peaks{run[1].peak, run[2].peak, run[3].peak};
    const MohrCoulomb line = fit_mohr_coulomb(kConfining, peaks);
    const std::array<double, 6> found{run[0].peak,    run[1].peak, line.cohesion_mpa, line.friction_angle_deg,
                                      run[1].modulus, run[1].ratio};
    for (std::size_t q = 0; q < 6; ++q) values[q].push_back(found[q]);
  }
  std::array<std::string, 6> text;
  for (std::size_t q = 0; q < 6; ++q) text[q] = mean_and_deviation(values[q]);
  return text;
}

struct Job {
  std::size_t row;
  int seed;
  std::size_t test;
};

std::vector<Job> list_jobs(std::size_t row_count, int seeds) {
  std::vector<Job> jobs;
  for (std::size_t row = 0; row < row_count; ++row) {
    for (int seed = 0; seed < seeds; ++seed) {
      for (std::size_t test = 0; test < kTests.size(); ++test) jobs.push_back({row, seed, test});
    }
  }
  return jobs;
}

using Outcomes = std::vector<std::vector<std::array<Outcome, 4>>>;  // [row][seed][test]

Outcomes run_all(const std::vector<Row>& table, const AuditOptions& options) {
  Outcomes outcomes(table.size(), std::vector<std::array<Outcome, 4>>(options.seeds));
  const std::vector<Job> jobs = list_jobs(table.size(), options.seeds);
  const std::filesystem::path configs = shipped(options.configs);
  std::mutex mutex;
  std::size_t done = 0;
  const int workers =
      options.jobs > 0 ? options.jobs : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  oneapi::tbb::task_arena arena(workers);
  arena.execute([&] {
    oneapi::tbb::parallel_for(std::size_t{0}, jobs.size(), [&](std::size_t i) {
      if (interruption_requested()) return;
      const Job& job = jobs[i];
      std::vector<std::string> overrides = table[job.row].overrides;
      overrides.push_back(fmt::format("/particles/seed={}", job.seed + 1));
      if (job.test > 0)
        overrides.push_back(fmt::format("/measurement/peak_strain_limit={}", table[job.row].strain_limit));
      if (job.test > 0)
        overrides.push_back(fmt::format("/experiment/stop/axial_strain={}", 1.05 * table[job.row].strain_limit));
      Outcome outcome = run_test(configs / (std::string(kTests[job.test]) + ".json"), overrides);
      const std::lock_guard lock(mutex);
      outcomes[job.row][job.seed][job.test] = outcome;
      std::cerr << fmt::format("{:3d} of {}: {}, {}, seed {}: {:.4g} MPa {}\n", ++done, jobs.size(),
                               table[job.row].name, kTests[job.test], job.seed + 1, outcome.peak, outcome.failure);
    });
  });
  return outcomes;
}

std::string markdown(const std::vector<Row>& table, const Outcomes& outcomes) {
  std::string text = "| reading | |";
  for (const char* q : kQuantities) text += fmt::format(" {} |", q);
  text += "\n|---|---|---|---|---|---|---|---|\n";
  text += "| the paper's Table 6 | | 1.6 | 7.4 | 1.77 | 40.3 | 1.3 | 0.20 |\n";
  for (std::size_t r = 0; r < table.size(); ++r) {
    text += fmt::format("| {} | here |", table[r].name);
    for (const std::string& value : evaluate(outcomes[r])) text += fmt::format(" {} |", value);
    if (table[r].before[0] != "-") {
      text += "\n| | before |";
      for (const std::string& value : table[r].before) text += fmt::format(" {} |", value);
    }
    text += "\n";
  }
  return text;
}

std::string csv(const std::vector<Row>& table, const Outcomes& outcomes) {
  std::string text = "reading,seed,test,peak_mpa,youngs_modulus_gpa,poissons_ratio,failure\n";
  for (std::size_t r = 0; r < table.size(); ++r) {
    for (std::size_t seed = 0; seed < outcomes[r].size(); ++seed) {
      for (std::size_t t = 0; t < kTests.size(); ++t) {
        const Outcome& o = outcomes[r][seed][t];
        text += fmt::format("\"{}\",{},{},{},{},{},\"{}\"\n", table[r].name, seed + 1, kTests[t], o.peak, o.modulus,
                            o.ratio, o.failure);
      }
    }
  }
  return text;
}

}  // namespace

int audit_command(const AuditOptions& options) {
  install_interruption_handlers();
  const std::vector<Row> table = chosen_rows(options.rows);
  const Outcomes outcomes = run_all(table, options);
  if (interruption_requested()) return 130;
  std::error_code ignored;
  std::filesystem::create_directories(options.out, ignored);
  write_file_atomically(options.out / "table.csv", csv(table, outcomes));
  const std::string text = markdown(table, outcomes);
  write_file_atomically(options.out / "table.md", text);
  std::cout << text << options.out.string() << std::endl;
  return 0;
}

}  // namespace asperity::app
