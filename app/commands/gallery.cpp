#include "app/gallery/gallery.hpp"

#include <algorithm>
#include <iostream>
#include <iterator>

#include "app/commands/commands.hpp"
#include "app/exit_code.hpp"
#include "app/installation.hpp"
#include "app/interruption.hpp"
#include "app/result_folder.hpp"
#include "core/base/log.hpp"
#include "core/output/run_folder.hpp"

namespace asperity::app {
namespace {

std::vector<CampaignRun> all_runs(const Gallery& gallery) {
  std::vector<CampaignRun> runs;
  for (const GalleryRuns& part : gallery.parts) runs.insert(runs.end(), part.runs.begin(), part.runs.end());
  return runs;
}

void take_outcomes(Gallery& gallery, const std::vector<CampaignOutcome>& outcomes) {
  std::size_t next = 0;
  for (GalleryRuns& part : gallery.parts) {
    const auto from = outcomes.begin() + static_cast<std::ptrdiff_t>(next);
    part.outcomes.assign(from, from + static_cast<std::ptrdiff_t>(part.runs.size()));
    next += part.runs.size();
  }
}

std::vector<std::uint64_t> seeds_of(int count) {
  std::vector<std::uint64_t> seeds;
  for (int i = 1; i <= count; ++i) seeds.push_back(static_cast<std::uint64_t>(i));
  return seeds;
}

}  // namespace

int gallery_command(const GalleryOptions& options) {
  install_interruption_handlers();
  if (options.session.quiet) set_log_echo(LogEcho::errors);
  std::vector<MechanismDeclaration> mechanisms;
  for (const std::string& id : options.mechanisms) mechanisms.push_back(mechanism_or_fault(id));
  if (mechanisms.empty()) mechanisms = declared_mechanisms();
  std::vector<std::filesystem::path> bases;
  for (const std::filesystem::path& base : options.bases) bases.push_back(shipped(base));
  Gallery gallery = plan_gallery(bases, mechanisms, seeds_of(options.seeds));
  const std::filesystem::path out = options.out.value_or(default_run_folder("gallery"));
  make_folder(out);
  const std::vector<CampaignOutcome> outcomes = compute_campaign("gallery", all_runs(gallery), {}, options.session);
  tell_failures(outcomes);
  const bool interrupted = std::any_of(outcomes.begin(), outcomes.end(),
                                       [](const CampaignOutcome& o) { return o.status == RunStatus::interrupted; });
  if (interrupted) {
    std::cerr << "interrupted; the same command goes on from there\n";
    return kExitInterrupted;
  }
  take_outcomes(gallery, outcomes);
  compare_features(gallery);
  std::cout << write_gallery(gallery, out).string() << std::endl;
  return kExitDone;
}

}  // namespace asperity::app
