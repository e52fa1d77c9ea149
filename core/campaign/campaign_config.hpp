#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/campaign/campaign.hpp"

namespace asperity {

/// A campaign file (configs/schema/campaign.schema.json) with its runs made and checked.
struct CampaignConfig {
  std::string name;
  std::string description;
  SlurmConfig slurm;
  std::vector<CampaignRun> runs;        ///< The grid (base, then each entry of "vary", then the seed), then "runs".
  std::vector<std::string> base_names;  ///< Of each run: the stem of the configuration it was made from.
  std::vector<std::string> varied;      ///< Pointers in which the runs differ by the file's will, without the seed's.
};

/// The section "slurm" of a document that holds to its schema; what is not there keeps its default.
SlurmConfig slurm_section(const nlohmann::json& document);

/// Reads the file. An override ("/json/pointer=value") at a key of the campaign schema changes the campaign, any other
/// is laid over every run, above all that the file sets. Throws one Error: of kind config with every fault, at its
/// pointer in the campaign file, or at its pointer in the run with the run's label; or of kind usage if an override is
/// malformed.
CampaignConfig read_campaign_config(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

}  // namespace asperity
