#include "core/confrontation/shown_runs.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/confrontation/shown_json.hpp"
#include "core/measurement/telling_rows.hpp"
#include "tests/unit/confrontation/confrontation_folder.hpp"

using namespace asperity;
using Eigen::VectorXd;

namespace {

/// A confrontation of the folder's tests that ended at the reference, with platen friction kept or nothing.
Confrontation ended(const ConfrontationConfig& config, bool kept) {
  Confrontation c;
  const auto parameters = static_cast<Eigen::Index>(config.parameters.size());
  c.centre = c.base.coded = VectorXd::Zero(parameters);
  c.evidence.candidates.push_back({"platen_friction", 0.6, false, false, 3.0});
  if (!kept) return c;
  HypothesisFit fit;
  fit.causes = {0};
  fit.amplitude = VectorXd::Constant(1, 0.5);
  fit.coded = VectorXd::Constant(parameters, 1.0);
  c.conclusion.kept.push_back(fit);
  return c;
}

}  // namespace

TEST_CASE("base and extension are shown on the same three meshes, the first with the frame at its end") {
  const testing::ConfrontationFolder folder("shown");
  const ConfrontationConfig config = folder.read(testing::confrontation());
  const std::vector<ShownRuns> shown = plan_shown_runs(config, ended(config, true));
  REQUIRE(shown.size() == 2 * config.measured.tests.size());
  for (const ShownRuns& part : shown) {
    REQUIRE(part.runs.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(part.runs[i].config.particles.seed == config.meshes.first_seed + i);
      CHECK(part.runs[i].config.output.frames == (i == 0 ? 1 : 0));
    }
  }
  CHECK(shown[0].model == FinalModel::base);
  CHECK(shown[0].runs[0].config.mechanisms.empty());
  REQUIRE(shown[1].runs[0].config.mechanisms.size() == 1);
  CHECK(shown[1].runs[0].config.mechanisms[0].amplitude == 0.5);
  // a step of the cohesion's logarithm above the base's
  const double base = shown[0].runs[0].config.contacts.cohesion_mpa;
  CHECK(shown[1].runs[0].config.contacts.cohesion_mpa == Approx(base * std::exp(0.08)));
}

TEST_CASE("a mechanism is left out of an extension's test in which it cannot act") {
  const testing::ConfrontationFolder folder("shown_joint");
  const ConfrontationConfig config = folder.read(testing::confrontation());
  for (const ShownRuns& part : plan_shown_runs(config, ended(config, true))) {
    if (part.test == "J") CHECK(part.runs[0].config.mechanisms.empty());
  }
}

TEST_CASE("without a kept cause the base alone is shown, and outcomes go back to their runs") {
  const testing::ConfrontationFolder folder("shown_base");
  const ConfrontationConfig config = folder.read(testing::confrontation());
  std::vector<ShownRuns> shown = plan_shown_runs(config, ended(config, false));
  REQUIRE(shown.size() == config.measured.tests.size());
  std::vector<CampaignOutcome> outcomes;
  for (const CampaignRun& run : listed_runs(shown)) outcomes.push_back({run.label, {}, {}, {}, {}, {}, {}});
  take_outcomes(shown, outcomes);
  for (const ShownRuns& part : shown) {
    REQUIRE(part.outcomes.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) CHECK(part.outcomes[i].label == part.runs[i].label);
  }
}

TEST_CASE("telling rows keep the ends and every stretch's extremes") {
  std::vector<double> values(100, 1.0);
  values[37] = 9.0;
  values[62] = -9.0;
  const std::vector<std::size_t> rows = telling_rows(values, 5);
  CHECK(rows.front() == 0);
  CHECK(rows.back() == 99);
  CHECK(std::find(rows.begin(), rows.end(), 37) != rows.end());
  CHECK(std::find(rows.begin(), rows.end(), 62) != rows.end());
  CHECK(rows.size() <= 12);
  CHECK(std::is_sorted(rows.begin(), rows.end()));
  CHECK(telling_rows({}, 5).empty());
  CHECK(telling_rows({3.0}, 5) == std::vector<std::size_t>{0});
}
