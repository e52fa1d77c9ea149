#include <algorithm>
#include <chrono>
#include <iostream>

#include "app/calibration_pictures.hpp"
#include "app/commands/commands.hpp"
#include "app/exit_code.hpp"
#include "app/interruption.hpp"
#include "app/result_folder.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/log.hpp"
#include "core/calibration/data_procedure.hpp"
#include "core/calibration/simulated_procedure.hpp"
#include "core/config/read_config.hpp"
#include "core/output/manifest.hpp"
#include "core/output/run_folder.hpp"

namespace asperity::app {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kResults{"calibration.json", "report.html", "configs", "plots", "pictures"};

void print_verification(const SimulatedResult& result) {
  for (const Verification& v : result.verified.verification) {
    std::cout << v.property << " " << v.mean << " +- " << v.sd << " (target " << v.target << ", " << v.values.size()
              << " meshes, " << (v.within ? "within" : "outside") << " its tolerance)\n";
  }
}

int calibrate_simulated(const CalibrateCommandOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  const SimulatedCalibration calibration = read_simulated_calibration(options.config, options.overrides);
  const fs::path out = options.out.value_or(default_run_folder(calibration.name));
  Manifest manifest = begin_study({out, calibration.name, calibration.config_hash, kResults}, options.config,
                                  options.force ? ExistingRun::replace : ExistingRun::keep);
  const Simulator simulate = [&](const std::string& stage, const std::vector<CampaignRun>& runs) {
    const std::vector<CampaignOutcome> outcomes = compute_campaign(stage, runs, calibration.slurm, options.session);
    tell_failures(outcomes);
    return outcomes;
  };
  try {
    const SimulatedResult result = calibrate(calibration, simulate);
    const std::vector<std::string> configs = write_calibrated_configs(calibration, result, out);
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
    write_file_atomically(out / "calibration.json",
                          calibration_json(calibration, result, configs, wall.count()).dump(2) + "\n");
    end_manifest(manifest, Outcome::finished, "calibrated");
    write_manifest(out / "manifest.json", manifest);
    draw_calibration(out, result);
    print_verification(result);
  } catch (const CalibrationInterrupted&) {
    end_manifest(manifest, Outcome::interrupted, "interrupted; the same command goes on from the runs in the store");
    write_manifest(out / "manifest.json", manifest);
    std::cerr << "interrupted; the same command goes on from there\n";
    return kExitInterrupted;
  }
  std::cout << out.string() << std::endl;
  return kExitDone;
}

int calibrate_on_data(const CalibrateCommandOptions& options) {
  const DataCalibration calibration = read_data_calibration(options.config);
  const fs::path out = options.out.value_or(default_run_folder(calibration.name));
  make_folder_with_config(out, options.config);
  const Analysis analysis = calibrate_data(options.config, out);
  draw_calibration(out);
  std::cout << analysis.solutions.size() << " solution(s) inside the design\n" << out.string() << std::endl;
  return kExitDone;
}

}  // namespace

int calibrate_command(const CalibrateCommandOptions& options) {
  install_interruption_handlers();
  if (options.session.quiet) set_log_echo(LogEcho::errors);
  return is_data_calibration(options.config, options.overrides) ? calibrate_on_data(options)
                                                                : calibrate_simulated(options);
}

}  // namespace asperity::app
