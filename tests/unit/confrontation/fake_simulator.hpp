#pragma once
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "core/calibration/test_suite.hpp"
#include "core/config/write_config.hpp"

namespace asperity::testing {

/// Makes discs' run folders in the place of the solver: a peak that grows with the mesh's seed.
class FakeSimulator {
 public:
  explicit FakeSimulator(std::filesystem::path root) : root_(std::move(root)) {}

  double peak_factor = 1.0;         ///< Another code's results.
  std::set<std::uint64_t> failing;  ///< Seeds of runs that fail.
  bool interrupted = false;
  std::vector<std::string> stages;  ///< Of each call.
  std::size_t computed = 0;

  Simulator function() {
    return [this](const std::string& stage, const std::vector<CampaignRun>& runs) {
      stages.push_back(stage);
      std::vector<CampaignOutcome> outcomes;
      for (const CampaignRun& run : runs) outcomes.push_back(compute(run));
      return outcomes;
    };
  }

 private:
  CampaignOutcome compute(const CampaignRun& run) {
    CampaignOutcome outcome{run.label, root_ / config_hash(run.config).substr(0, 16), RunStatus::finished, false, "", 0,
                            0.0};
    if (interrupted) outcome.status = RunStatus::interrupted;
    if (failing.contains(run.config.particles.seed)) {
      outcome.status = RunStatus::failed;
      outcome.reason = "the disc ran away";
    }
    ++computed;
    outcome.compute_s = 0.5;
    if (outcome.status == RunStatus::finished) write(outcome.folder, run.config);
    return outcome;
  }

  void write(const std::filesystem::path& folder, const RunConfig& config) const {
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "config.effective.json") << effective_json(config);
    std::ofstream curves(folder / "curves.csv");
    curves << "platen_displacement_mm,load_n_per_mm,cracks_tension,cracks_shear\n";
    const double peak = peak_factor * (100.0 + static_cast<double>(config.particles.seed) / 7.0);
    for (int i = 0; i <= 40; ++i) {
      const double rise = std::min(i, 30) / 30.0, fall = std::max(i - 30, 0) / 10.0;
      curves << 0.01 * i << "," << peak * (rise - fall) << "," << i / 3 << "," << i / 9 << "\n";
    }
  }

  std::filesystem::path root_;
};

inline RunConfig disc_config(std::uint64_t seed) {
  RunConfig config;
  config.experiment.type = ExperimentType::brazilian;
  config.particles.seed = seed;
  return config;
}

inline std::vector<CampaignRun> disc_runs(std::uint64_t first, std::uint64_t last) {
  std::vector<CampaignRun> runs;
  for (std::uint64_t seed = first; seed <= last; ++seed)
    runs.push_back({"B, mesh " + std::to_string(seed), disc_config(seed)});
  return runs;
}

}  // namespace asperity::testing
