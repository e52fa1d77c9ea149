#include "core/confrontation/shown_runs.hpp"

namespace asperity {
namespace {

constexpr std::uint64_t kMeshes = 3;

ShownRuns runs_of(const ConfrontationConfig& config, const Confrontation& confrontation, const MeasuredTest& test,
                  FinalModel model) {
  ShownRuns shown{test.id, model, {}, {}};
  const std::string name = model == FinalModel::base ? "base" : "extension";
  for (std::uint64_t i = 0; i < kMeshes; ++i) {
    const std::uint64_t seed = config.meshes.first_seed + i;
    RunConfig run = final_run(config, confrontation, test, model, VirtualOutput::least, seed);
    run.output.frames = i == 0 ? 1 : 0;
    shown.runs.push_back({test.id + " " + name + " shown, seed=" + std::to_string(seed), std::move(run), 0.0});
  }
  return shown;
}

}  // namespace

std::vector<ShownRuns> plan_shown_runs(const ConfrontationConfig& config, const Confrontation& confrontation) {
  std::vector<ShownRuns> shown;
  for (const MeasuredTest& test : config.measured.tests) {
    shown.push_back(runs_of(config, confrontation, test, FinalModel::base));
    if (!confrontation.conclusion.kept.empty())
      shown.push_back(runs_of(config, confrontation, test, FinalModel::extension));
  }
  return shown;
}

std::vector<CampaignRun> listed_runs(const std::vector<ShownRuns>& shown) {
  std::vector<CampaignRun> runs;
  for (const ShownRuns& part : shown) runs.insert(runs.end(), part.runs.begin(), part.runs.end());
  return runs;
}

void take_outcomes(std::vector<ShownRuns>& shown, const std::vector<CampaignOutcome>& outcomes) {
  auto next = outcomes.begin();
  for (ShownRuns& part : shown) {
    const auto end = next + static_cast<std::ptrdiff_t>(part.runs.size());
    part.outcomes.assign(next, end);
    next = end;
  }
}

}  // namespace asperity
