#include "app/campaign_session.hpp"

#include <iostream>

#include "app/campaign_progress.hpp"
#include "app/installation.hpp"
#include "app/interruption.hpp"

namespace asperity::app {

std::vector<CampaignOutcome> compute_campaign(const std::string& name, const std::vector<CampaignRun>& runs,
                                              const SlurmConfig& slurm, const CampaignSessionOptions& options) {
  CampaignProgressLine progress(name, options.quiet ? ProgressStyle::quiet : progress_style_of_stderr(), std::cerr);
  CampaignOptions campaign;
  campaign.store = options.store;
  campaign.executable = this_executable();
  campaign.jobs = options.jobs;
  campaign.executor = options.executor == "slurm" ? Executor::slurm : Executor::local;
  campaign.slurm = slurm;
  campaign.interrupted = interruption_requested;
  campaign.on_progress = [&](const CampaignProgress& p) { progress.update(p); };
  std::vector<CampaignOutcome> outcomes = run_campaign(runs, campaign);
  progress.finish();
  return outcomes;
}

void tell_failures(const std::vector<CampaignOutcome>& outcomes) {
  for (const CampaignOutcome& outcome : outcomes) {
    if (outcome.status != RunStatus::failed) continue;
    std::cerr << "failed: " << outcome.label << ": " << outcome.reason << " (exit code " << outcome.exit_code << ", "
              << outcome.folder.string() << (outcome.reused ? ", as before; not repeated" : "") << ")\n";
  }
}

}  // namespace asperity::app
