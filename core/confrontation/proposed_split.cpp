#include "core/confrontation/proposed_split.hpp"

#include <algorithm>

namespace asperity {
namespace {

bool is_joint(const MeasuredTest& test) { return test.experiment == ExperimentType::direct_shear; }
bool has_level(const MeasuredTest& test) { return test.experiment != ExperimentType::brazilian; }

/// What the test was pressed by across its load, MPa.
double level_of(const MeasuredTest& test) {
  return is_joint(test) ? test.normal_stress_mpa.value_or(0.0) : test.confining_pressure_mpa.value_or(0.0);
}

std::vector<double> levels(const MeasuredData& data, bool joints) {
  std::vector<double> all;
  for (const MeasuredTest& test : data.tests) {
    if (has_level(test) && is_joint(test) == joints) all.push_back(level_of(test));
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

std::size_t kept_back(const MeasuredData& data) {
  return static_cast<std::size_t>(std::count_if(data.tests.begin(), data.tests.end(),
                                                [](const MeasuredTest& t) { return t.use == TestUse::hold_out; }));
}

/// Keeps all tests of one level back unless too few would stay.
void keep_back(MeasuredData& data, bool joints, double level) {
  std::vector<MeasuredTest*> chosen;
  for (MeasuredTest& test : data.tests) {
    if (has_level(test) && is_joint(test) == joints && level_of(test) == level) chosen.push_back(&test);
  }
  if (3 * (kept_back(data) + chosen.size()) > data.tests.size()) return;
  for (MeasuredTest* test : chosen) test->use = TestUse::hold_out;
}

}  // namespace

void propose_split(MeasuredData& data) {
  for (MeasuredTest& test : data.tests) test.use = TestUse::fit;
  for (const bool joints : {false, true}) {
    const std::vector<double> all = levels(data, joints);
    for (std::size_t i = 2; i + 1 < all.size(); i += 3) keep_back(data, joints, all[i]);
  }
}

}  // namespace asperity
