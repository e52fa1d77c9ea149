#include "core/campaign/campaign.hpp"

#include <algorithm>
#include <chrono>
#include <iostream>

#include "app/commands/commands.hpp"
#include "app/exit_code.hpp"
#include "app/interruption.hpp"
#include "app/joint_envelope.hpp"
#include "app/result_folder.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/log.hpp"
#include "core/campaign/campaign_table.hpp"
#include "core/config/read_config.hpp"
#include "core/output/run_folder.hpp"

namespace asperity::app {
namespace {

namespace fs = std::filesystem;

bool any_interrupted(const std::vector<CampaignOutcome>& outcomes) {
  return std::any_of(outcomes.begin(), outcomes.end(),
                     [](const CampaignOutcome& o) { return o.status == RunStatus::interrupted; });
}

/// The code of the first failed run where that is one of ours; a killed one is unexpected.
int exit_code_of(const std::vector<CampaignOutcome>& outcomes) {
  for (const CampaignOutcome& outcome : outcomes) {
    if (outcome.status != RunStatus::failed) continue;
    const bool ours = outcome.exit_code > 0 && outcome.exit_code <= exit_code(ErrorKind::tolerance);
    return ours ? outcome.exit_code : exit_code(ErrorKind::unexpected);
  }
  return kExitDone;
}

}  // namespace

int campaign_command(const CampaignCommandOptions& options) {
  install_interruption_handlers();
  if (options.session.quiet) set_log_echo(LogEcho::errors);
  const auto begin = std::chrono::steady_clock::now();
  const CampaignConfig config = read_campaign_config(options.config, options.overrides);
  const fs::path out = options.out.value_or(default_run_folder(config.name));
  make_folder(out);
  write_file_atomically(out / "config.original.json", read_config_text(options.config));
  const std::vector<CampaignOutcome> outcomes =
      compute_campaign(config.name, config.runs, config.slurm, options.session);
  const double wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  write_campaign_table(out / "table.csv", config, outcomes);
  write_campaign_json(out / "campaign.json", config, outcomes, wall_s);
  tell_failures(outcomes);
  if (any_interrupted(outcomes)) {
    std::cerr << "interrupted; the same command goes on from there\n";
    return kExitInterrupted;
  }
  draw_joint_envelope(config, outcomes, out);
  std::cout << (out / "table.csv").string() << std::endl;
  return exit_code_of(outcomes);
}

}  // namespace asperity::app
