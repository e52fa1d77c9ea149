#include <algorithm>
#include <iostream>

#include "app/commands/commands.hpp"
#include "app/confrontation/confrontation_report.hpp"
#include "app/exit_code.hpp"
#include "app/interruption.hpp"
#include "app/result_folder.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/log.hpp"
#include "core/confrontation/confrontation_task.hpp"
#include "core/confrontation/feature_source.hpp"
#include "core/confrontation/golden_runs.hpp"
#include "core/confrontation/next_tests.hpp"
#include "core/confrontation/shown_json.hpp"
#include "core/output/manifest.hpp"
#include "core/output/run_folder.hpp"

namespace asperity::app {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kResults{"frozen.json", "verdict.json", "shown.json", "report.html",
                                        "report.md",   "configs",      "plots",      "pictures"};

void print_verdict(const Confrontation& confrontation, const FeatureCost& cost) {
  std::cout << "status " << word(confrontation.conclusion.status);
  for (const std::string& cause : verdict_causes(confrontation)) std::cout << " " << cause;
  std::cout << "\n"
            << cost.runs << " runs: " << cost.from_bank << " from the bank, " << cost.from_store << " from the store, "
            << cost.computed << " computed, " << cost.failed << " failed, " << cost.checked << " checked\n";
}

void require_end(const std::vector<CampaignOutcome>& outcomes) {
  const auto interrupted = [](const CampaignOutcome& o) { return o.status == RunStatus::interrupted; };
  if (std::any_of(outcomes.begin(), outcomes.end(), interrupted)) throw CalibrationInterrupted{};
}

/// The runs that are shown, shown.json, and the page.
void show(const ConfrontationConfig& config, const Confrontation& confrontation, const FeatureCost& cost,
          const Simulator& simulate, const fs::path& out) {
  std::vector<ShownRuns> shown = plan_shown_runs(config, confrontation);
  const std::vector<CampaignOutcome> outcomes = simulate("runs that are shown", listed_runs(shown));
  require_end(outcomes);
  take_outcomes(shown, outcomes);
  write_file_atomically(out / "shown.json", shown_json(config, confrontation, shown, cost).dump(1) + "\n");
  write_confrontation_report(out);
}

/// Before runs that would take hours.
void require_folder_of(const fs::path& bank, const fs::path& out) {
  const fs::path folder = fs::absolute(bank).lexically_normal().parent_path();
  if (!fs::is_directory(folder) && folder != (fs::absolute(out) / "").lexically_normal().parent_path())
    throw Error(ErrorKind::output, {{"--write-bank", "lies in no folder", bank.string(),
                                     "a file in a folder that exists", "create " + folder.string() + " first"}});
}

void carry_through(const ConfrontCommandOptions& options, const ConfrontationConfig& config, const fs::path& out) {
  const Simulator simulate = [&](const std::string& stage, const std::vector<CampaignRun>& runs) {
    std::vector<CampaignOutcome> outcomes =
        compute_campaign(config.name + ": " + stage, runs, config.slurm, options.session);
    tell_failures(outcomes);
    return outcomes;
  };
  FeatureSource source({options.session.store, config.bank, options.check_share, options.check_seed}, simulate);
  if (!source.bank_refused().empty())
    std::cerr << "the bank " << config.bank->string() << " does not count: " << source.bank_refused() << "\n";
  const FeaturesOf features = [&](const std::string& stage, const std::vector<CampaignRun>& runs) {
    std::vector<RunFeatureValues> values;
    for (RunFeatures& run : source.features(stage, runs)) values.push_back(std::move(run.values));
    return values;
  };
  ConfrontationTask task = confrontation_task(config, features);
  task.options.draws.at_each_draw = [] {
    if (interruption_requested()) throw CalibrationInterrupted{};
  };
  write_file_atomically(out / "frozen.json", frozen_record(config, task));
  const Confrontation confrontation = confront(task);
  VerdictContext context = verdict_context(config, task, confrontation);
  const auto write_verdict = [&] {
    write_file_atomically(out / "verdict.json", verdict_json(confrontation, context).dump(2) + "\n");
  };
  write_verdict();
  context.extended_config = write_extended_configs(config, confrontation, out);
  if (options.next_tests || config.linearise_at == LineariseAt::calibrated)
    context.next_tests = next_tests(config, task, confrontation);
  write_verdict();
  if (options.write_bank) write_bank(*options.write_bank, source.gathered(golden_runs(config)));
  print_verdict(confrontation, source.cost());
  if (options.report) show(config, confrontation, source.cost(), simulate, out);
}

}  // namespace

int confront_command(const ConfrontCommandOptions& options) {
  install_interruption_handlers();
  if (options.session.quiet) set_log_echo(LogEcho::errors);
  const ConfrontationConfig config = read_confrontation(options.config, options.overrides);
  const fs::path out = options.out.value_or(default_run_folder(config.name));
  if (options.write_bank) require_folder_of(*options.write_bank, out);
  Manifest manifest = begin_study({out, config.name, confrontation_hash(config), kResults}, options.config,
                                  options.force ? ExistingRun::replace : ExistingRun::keep);
  try {
    carry_through(options, config, out);
  } catch (const CalibrationInterrupted&) {
    end_manifest(manifest, Outcome::interrupted, "interrupted; the same command goes on from the runs in the store");
    write_manifest(out / "manifest.json", manifest);
    std::cerr << "interrupted; the same command goes on from there\n";
    return kExitInterrupted;
  } catch (const std::exception& error) {
    end_manifest(manifest, Outcome::failed, error.what());
    write_manifest(out / "manifest.json", manifest);
    throw;
  }
  end_manifest(manifest, Outcome::finished, "confronted");
  write_manifest(out / "manifest.json", manifest);
  std::cout << out.string() << std::endl;
  return kExitDone;
}

}  // namespace asperity::app
