#include "core/campaign/campaign_progress.hpp"

#include <catch2/catch.hpp>

#include "core/config/estimates.hpp"

using namespace asperity;

TEST_CASE("expected cost is particles times steps") {
  RunConfig config;
  config.experiment.type = ExperimentType::brazilian;
  config.experiment.diameter_mm = 50;
  config.experiment.loading.closing_rate_mm_per_s = 100;
  config.experiment.stop.axial_strain = 0.02;
  config.integration.time_step_s = 1e-6;
  // 0.02 x 50 mm at 100 mm/s take 0.01 s: 10,000 steps.
  CHECK(expected_cost(config) == Approx(1e4 * estimated_triangles(config)));
  config.integration.time_step_s.reset();
  const double steps = 0.01 / (config.integration.safety_factor * estimated_critical_step(config));
  CHECK(expected_cost(config) == Approx(steps * estimated_triangles(config)));
}

TEST_CASE("time left: cost that is left at the measured speed, over the runs at work") {
  ProgressLedger ledger;
  for (double cost : {1.0, 2.0, 3.0, 4.0}) ledger.add_job(cost, 1);
  CHECK_FALSE(ledger.at(0).left_s);
  ledger.start(0, 0);
  ledger.start(1, 0);
  CHECK_FALSE(ledger.at(5).left_s);
  ledger.finish(0, 10, false);  // 10 s for a cost of 1
  ledger.start(2, 10);
  // Left: 20 s less 12 s of the second, 30 s less 2 s of the third, 40 s of the fourth, on two workers.
  CHECK(ledger.at(12).left_s == Approx((8 + 28 + 40) / 2.0));
  CHECK(ledger.at(12).fraction == Approx(0.1));
  CHECK(ledger.at(12).running == 2);
}

TEST_CASE("what was re-used tells the speed too, what failed does not") {
  ProgressLedger ledger;
  for (int i = 0; i < 3; ++i) ledger.add_job(1, 1);
  ledger.reuse(0, 6, false);
  CHECK(ledger.at(0).left_s == Approx(12));
  ledger.finish(1, 0.1, true);
  CHECK(ledger.at(0).left_s == Approx(6));
  CHECK(ledger.at(0).failed == 1);
  CHECK(ledger.at(0).reused == 1);
  CHECK(ledger.at(0).done == 2);
}

TEST_CASE("a run that takes longer than expected has no time left, not less") {
  ProgressLedger ledger;
  ledger.add_job(1, 1);
  ledger.add_job(1, 3);
  ledger.reuse(0, 5, false);
  ledger.start(1, 0);
  CHECK(ledger.at(100).left_s == 0.0);
  ledger.stop(1);
  CHECK(ledger.at(100).running == 0);
  CHECK(ledger.at(100).runs == 4);
  ledger.finish(1, 5, false);
  CHECK(ledger.at(100).done == 4);
  CHECK(ledger.at(100).fraction == 1.0);
}

TEST_CASE("no runs are a whole campaign") { CHECK(ProgressLedger().at(0).fraction == 1.0); }
