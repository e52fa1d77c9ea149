#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/campaign/campaign_progress.hpp"
#include "core/campaign/slurm_config.hpp"
#include "core/config/run_config.hpp"

namespace asperity {

/// One run of a campaign. What identifies it is config_hash(config): name and description play no part.
struct CampaignRun {
  std::string label;
  RunConfig config;
  double expected_cost = 0;  ///< In one unit for all runs, for the time left; 0: Eq. (Q1).
};

/// How a run stands when its campaign returns.
enum class RunStatus { finished, failed, interrupted };

struct CampaignOutcome {
  std::string label;
  std::filesystem::path folder;  ///< Of the run, in the store; a run that failed early may have left none.
  RunStatus status = RunStatus::interrupted;
  bool reused = false;  ///< Nothing was computed for it: it lay in the store, or it stands twice in the list.
  std::string reason;   ///< Why it ended, one line.
  int exit_code = 0;    ///< Of the process; 128 + the signal that killed it.
  double compute_s = 0;
};

/// Where the runs are computed.
enum class Executor { local, slurm };

struct CampaignOptions {
  std::filesystem::path store;       ///< Folder of the run folders; campaigns may share it.
  std::filesystem::path executable;  ///< `asperity`, of this very build: folders made by other code are not re-used.
  int jobs = 0;                      ///< Local processes at once; 0: one a core.
  Executor executor = Executor::local;
  SlurmConfig slurm;
  std::function<bool()> interrupted;                         ///< Asked often; true ends the campaign early.
  std::function<void(const CampaignProgress&)> on_progress;  ///< Called often, a few times a second at least.
};

/// Computes every run that the store does not hold yet, each in a process of its own with one thread, and returns the
/// outcomes in the order of the runs. Runs of one configuration are computed once. A failed run does not stop the rest,
/// and one that would fail in the same way again (exit codes 3, 4, 6, same code) is told, not repeated. Interrupted,
/// the runs in work write checkpoints; called again, the campaign goes on from there, as it does after a kill. Which
/// results lie in the store does not depend on jobs, executor or interruptions.
///
/// Throws Error(config) where the executable or Slurm is not there, or Slurm refuses what it is asked; Error(output)
/// where the store cannot be written.
std::vector<CampaignOutcome> run_campaign(const std::vector<CampaignRun>& runs, const CampaignOptions& options);

}  // namespace asperity
