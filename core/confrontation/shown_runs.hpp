#pragma once
#include <string>
#include <vector>

#include "core/campaign/campaign.hpp"
#include "core/confrontation/final_run.hpp"

/// The runs that a confrontation's report shows beside the measured curves. The verdict does not depend on them.
namespace asperity {

/// One model in one test, on a few meshes.
struct ShownRuns {
  std::string test;
  FinalModel model = FinalModel::base;
  std::vector<CampaignRun> runs;          ///< One a mesh; the first one keeps the frame at its end.
  std::vector<CampaignOutcome> outcomes;  ///< Of these, once computed.
};

/// The base in every test, and where a cause is kept the extension, on the same meshes.
std::vector<ShownRuns> plan_shown_runs(const ConfrontationConfig& config, const Confrontation& confrontation);

/// All runs in one list, and their outcomes back.
std::vector<CampaignRun> listed_runs(const std::vector<ShownRuns>& shown);
void take_outcomes(std::vector<ShownRuns>& shown, const std::vector<CampaignOutcome>& outcomes);

}  // namespace asperity
