#pragma once
#include <filesystem>

#include "core/campaign/campaign_config.hpp"

namespace asperity {

/// Writes OUT/table.csv: a row for each run with label, run (its folder's name in the store), config, the varied keys
/// by their pointers, seed, status, reason, every number of summary.json's "results", crack counts and the energy
/// balance's closure error. Cells are empty where a run has no such value. Equal campaigns give equal bytes, whatever
/// was interrupted, failed on the way or lay in the store. Throws Error(output).
void write_campaign_table(const std::filesystem::path& path, const CampaignConfig& config,
                          const std::vector<CampaignOutcome>& outcomes);

/// Writes OUT/campaign.json: the same rows with what depends on this call: folder, re-use, exit code, compute time; and
/// the campaign's cost. Throws Error(output).
void write_campaign_json(const std::filesystem::path& path, const CampaignConfig& config,
                         const std::vector<CampaignOutcome>& outcomes, double wall_s);

/// "finished", "failed" or "interrupted".
const char* status_word(RunStatus status);

}  // namespace asperity
