#include "core/confrontation/short_runs.hpp"

#include <algorithm>

#include "core/confrontation/extension_runs.hpp"

namespace asperity {
namespace {

using Eigen::Index;

/// Runs of one point by slots, read as the specimens are: a strength is that of a peak which was passed.
Samples as_measured(const ConfrontationTask& task, const Confrontation& state, const TestEvidence& test,
                    const ExtensionPoint& point) {
  TestEvidence own = test;
  for (FeatureSlot& slot : own.slots) slot.simulated = nullptr;
  const auto number = static_cast<std::size_t>(&test - state.evidence.tests.data());
  const Index meshes = std::min<Index>(static_cast<Index>(task.common), test.base.rows());
  return simulate_specimens(own, extension_specimens(task, state, number, point, meshes),
                            extension_stage(state.evidence, point.causes), task.configure, task.features);
}

void add_short_runs(const ConfrontationTask& task, const Confrontation& state, const ComparedTest& part,
                    const ExtensionPoint& at, std::vector<ShortRuns>& found) {
  const TestEvidence& test = *part.test;
  const Samples base = as_measured(task, state, test, {{}, Eigen::VectorXd::Zero(at.coded.size()), {}});
  const Samples extension = as_measured(task, state, test, at);
  for (const Index column : part.columns) {
    const std::string feature(test.slots[static_cast<std::size_t>(column)].kind->name);
    const Index before = base.col(column).array().isFinite().count();
    const Index after = extension.col(column).array().isFinite().count();
    if (2 * before >= base.rows() && 2 * after < before)
      found.push_back({at.causes, test.id, feature, before, after, base.rows()});
  }
}

}  // namespace

std::vector<ShortRuns> short_runs(const ConfrontationTask& task, const Confrontation& state, const HypothesisFit& fit) {
  const ExtensionPoint at = point_of_run(state.evidence, {fit.causes, fit.coded, fit.amplitude});
  std::vector<ShortRuns> found;
  for (const Comparison* comparison : {&state.fitted, &state.kept_back}) {
    for (const ComparedTest& part : comparison->tests) add_short_runs(task, state, part, at, found);
  }
  return found;
}

}  // namespace asperity
