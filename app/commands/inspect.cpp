#include <iostream>
#include <thread>

#include "app/commands/commands.hpp"
#include "app/exit_code.hpp"
#include "app/libraries.hpp"
#include "app/pictures.hpp"
#include "core/base/build_info.hpp"
#include "core/base/error.hpp"
#include "core/calibration/data_calibration.hpp"
#include "core/calibration/simulated_config.hpp"
#include "core/campaign/campaign_config.hpp"
#include "core/config/read_config.hpp"
#include "core/config/schema.hpp"
#include "core/confrontation/confrontation_config.hpp"
#include "core/confrontation/read_measured.hpp"
#include "core/experiment/model.hpp"
#include "core/output/manifest.hpp"
#include "core/output/measured_curve.hpp"
#include "core/output/run_folder.hpp"

namespace asperity::app {

namespace {

/// A mesh for each run of a campaign would take as long as a run: they are checked when they are made.
void validate_campaign(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  const CampaignConfig config = read_campaign_config(path, overrides);
  std::cout << path.string() << ": valid (" << config.runs.size() << " runs)\n";
}

void validate_calibration(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  if (is_data_calibration(path, overrides)) {
    const DataCalibration calibration = read_data_calibration(path);
    std::cout << path.string() << ": valid (" << calibration.design.coded.size() << " rows of data)\n";
    return;
  }
  const SimulatedCalibration calibration = read_simulated_calibration(path, overrides);
  std::cout << path.string() << ": valid (" << calibration.factors.size() << " factors, "
            << calibration.suite.tests.size() << " tests)\n";
}

void validate_measured(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  if (!overrides.empty())
    throw Error(ErrorKind::usage, {{"--set", "does not apply to measured data", overrides.front(), "", ""}});
  const MeasuredData data = read_measured_data(path);
  std::size_t specimens = 0;
  for (const MeasuredTest& test : data.tests) specimens += specimens_of(test).size();
  std::cout << path.string() << ": valid (" << data.tests.size() << " measured tests, " << specimens << " specimens)\n";
}

void validate_confrontation(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  const ConfrontationConfig config = read_confrontation(path, overrides);
  std::cout << path.string() << ": valid (" << config.measured.tests.size() << " measured tests, "
            << config.parameters.size() << " parameters, " << config.mechanisms.size() << " mechanisms"
            << (config.split_proposed ? ", split proposed" : "") << ")\n";
}

void validate_run(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  const RunConfig config = read_run_config(path, overrides);
  read_measured_curves(config);
  const Model model = build_model(config, ParallelLoops());
  std::cout << path.string() << ": valid (" << model.mesh.triangles.size() << " triangles, time step "
            << model.system.time_step << " s)\n";
}

}  // namespace

int validate_command(const std::vector<std::filesystem::path>& configs, const std::vector<std::string>& overrides) {
  int code = 0;
  for (const std::filesystem::path& path : configs) {
    try {
      const std::string kind = config_kind(path);
      if (kind == "campaign") {
        validate_campaign(path, overrides);
      } else if (kind == "calibration") {
        validate_calibration(path, overrides);
      } else if (kind == "measured") {
        validate_measured(path, overrides);
      } else if (kind == "confrontation") {
        validate_confrontation(path, overrides);
      } else {
        validate_run(path, overrides);
      }
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::usage) throw;
      code = exit_code(error.kind());
      std::cerr << path.string() << ":\n" << error.what() << "\n";
    }
  }
  return code;
}

int schema_command(const std::string& kind) {
  std::cout << schema_text(kind);
  return 0;
}

int render_command(const RenderOptions& options) {
  const RunFolder folder = RunFolder::open(options.run_dir);
  draw_frames(folder, read_run_config(folder.effective_config()).output, options.fields, options.frames);
  std::cout << folder.frames().string() << std::endl;
  return 0;
}

int info_command() {
  const BuildInfo& build = build_info();
  std::cout << "asperity " << build.version << "\nrevision " << build.revision << (build.dirty ? " (changed)" : "")
            << "\ncompiler " << build.compiler << "\nflags " << build.flags << "\nbuild " << build.build_type << "\n";
  for (const auto& [name, version] : library_versions()) std::cout << name << " " << version << "\n";
  const Manifest here = started_manifest();
  std::cout << "processor " << here.host.cpu_model << ", " << here.host.cores << " cores\n";
  return 0;
}

}  // namespace asperity::app
