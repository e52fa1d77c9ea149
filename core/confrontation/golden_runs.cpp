#include "core/confrontation/golden_runs.hpp"

#include <array>

#include "core/confrontation/confrontation_task.hpp"
#include "core/confrontation/virtual_test.hpp"

namespace asperity {
namespace {

constexpr std::array kFastestFirst{ExperimentType::brazilian, ExperimentType::uniaxial, ExperimentType::triaxial,
                                   ExperimentType::direct_shear};

RunConfig run_of(const ConfrontationConfig& config, const RunConfig& test, std::vector<MechanismConfig> mechanisms) {
  return configured(test, config.parameters, reference_theta(config.parameters), std::move(mechanisms),
                    config.meshes.first_seed);
}

/// The first test of each kind, the kind that computes fastest first.
std::vector<RunConfig> first_tests(const ConfrontationConfig& config) {
  std::vector<RunConfig> tests;
  for (const ExperimentType type : kFastestFirst) {
    for (const MeasuredTest& test : config.measured.tests) {
      if (test.experiment != type) continue;
      tests.push_back(virtual_test(config, test));
      break;
    }
  }
  return tests;
}

}  // namespace

std::vector<RunConfig> golden_runs(const ConfrontationConfig& config) {
  const std::vector<RunConfig> tests = first_tests(config);
  std::vector<RunConfig> runs;
  for (const RunConfig& test : tests) runs.push_back(run_of(config, test, {}));
  for (const Candidate& candidate : library_candidates(config.mechanisms)) {
    for (const RunConfig& test : tests) {
      if (!can_act(test, candidate.id)) continue;
      runs.push_back(run_of(config, test, {{candidate.id, candidate.amplitude, {}}}));
      break;
    }
  }
  return runs;
}

}  // namespace asperity
