#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/campaign/campaign.hpp"

namespace asperity::app {

/// What the user chose of how a campaign is computed; results do not depend on it.
struct CampaignSessionOptions {
  std::filesystem::path store = "outputs/store";
  int jobs = 0;  ///< 0: one a core.
  std::string executor = "local";
  bool quiet = false;
};

/// Runs the campaign with this very executable, shows its progress on stderr under the name, and ends early on SIGINT
/// and SIGTERM (install_interruption_handlers() first).
std::vector<CampaignOutcome> compute_campaign(const std::string& name, const std::vector<CampaignRun>& runs,
                                              const SlurmConfig& slurm, const CampaignSessionOptions& options);

/// Says on stderr, a line each, which runs failed and why.
void tell_failures(const std::vector<CampaignOutcome>& outcomes);

}  // namespace asperity::app
