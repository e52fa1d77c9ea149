#include "core/confrontation/feature_source.hpp"

#include <catch2/catch.hpp>

#include "core/base/error.hpp"
#include "tests/unit/confrontation/fake_simulator.hpp"

using namespace asperity;
using namespace asperity::testing;
namespace fs = std::filesystem;

namespace {

/// A fresh store, a simulator, and the options that use both.
struct Laboratory {
  explicit Laboratory(const std::string& name)
      : root(fs::path(ASPERITY_TEST_SCRATCH) / "confrontation" / "source" / name), simulator(root / "runs") {
    fs::remove_all(root);
    options.store = root / "store";
  }
  FeatureSource source() { return FeatureSource(options, simulator.function()); }
  /// A bank of the meshes 1 to 6 with mesh 9 as its golden run.
  void make_bank() {
    FeatureSource maker = source();
    maker.features("bank", disc_runs(1, 6));
    write_bank(root / "bank.txt", maker.gathered({disc_config(9)}));
    fs::remove_all(options.store);
    options.bank = root / "bank.txt";
    simulator.stages.clear();
    simulator.computed = 0;
  }
  fs::path root;
  FakeSimulator simulator;
  FeatureSourceOptions options;
};

bool same(const std::vector<RunFeatures>& a, const std::vector<RunFeatures>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const RunFeatures& x, const RunFeatures& y) {
    return x.values == y.values && x.reason == y.reason;
  });
}

}  // namespace

TEST_CASE("runs are computed once, then told from the store with the same digits") {
  Laboratory lab("store");
  FeatureSource first = lab.source();
  std::vector<CampaignRun> runs = disc_runs(1, 4);
  runs.push_back(runs.front());
  const std::vector<RunFeatures> computed = first.features("noise", runs);
  CHECK(lab.simulator.computed == 4);
  REQUIRE(computed.size() == 5);
  CHECK(computed[0].values == computed[4].values);
  CHECK(computed[0].values != computed[1].values);
  CHECK(computed[2].values == rounded(computed[2].values));
  CHECK(first.cost().runs == 5);
  CHECK(first.cost().computed == 5);
  CHECK(first.cost().compute_s == 2.0);
  FeatureSource second = lab.source();
  CHECK(same(second.features("noise", runs), computed));
  CHECK(lab.simulator.computed == 4);
  CHECK(second.cost().from_store == 5);
  CHECK(second.cost().computed == 0);
  CHECK(second.features("none", {}).empty());
}

TEST_CASE("a failed run gives its reason and no features, and is not kept") {
  Laboratory lab("failed");
  lab.simulator.failing = {2};
  FeatureSource source = lab.source();
  const std::vector<RunFeatures> answers = source.features("noise", disc_runs(1, 2));
  CHECK_FALSE(answers[0].values.empty());
  CHECK(answers[1].values.empty());
  CHECK(answers[1].reason == "the disc ran away");
  CHECK(source.cost().failed == 1);
  lab.simulator.failing.clear();
  CHECK_FALSE(lab.source().features("noise", disc_runs(2, 2))[0].values.empty());
}

TEST_CASE("an interruption is thrown on") {
  Laboratory lab("interrupted");
  lab.simulator.interrupted = true;
  FeatureSource source = lab.source();
  CHECK_THROWS_AS(source.features("noise", disc_runs(1, 2)), CalibrationInterrupted);
}

TEST_CASE("a bank gives the same answers as the runs, once its golden runs have been computed") {
  Laboratory lab("bank");
  FeatureSource direct = lab.source();
  const std::vector<RunFeatures> computed = direct.features("noise", disc_runs(1, 8));
  lab.make_bank();
  FeatureSource source = lab.source();
  CHECK(source.bank_refused().empty());
  CHECK(lab.simulator.stages == std::vector<std::string>{"golden runs"});
  CHECK(same(source.features("noise", disc_runs(1, 8)), computed));
  CHECK(source.cost().from_bank == 6);
  CHECK(source.cost().computed == 2);
  CHECK(lab.simulator.computed == 3);
  lab.source();
  CHECK(lab.simulator.computed == 3);
}

TEST_CASE("a bank of another code does not count, and every run is computed") {
  Laboratory lab("other code");
  lab.make_bank();
  lab.simulator.peak_factor = 1.0 + 1e-15;
  FeatureSource source = lab.source();
  CHECK_THAT(source.bank_refused(), Catch::Contains("golden run 1, tensile_strength_mpa"));
  source.features("noise", disc_runs(1, 6));
  CHECK(source.cost().from_bank == 0);
  CHECK(source.cost().computed == 6);
  lab.simulator.failing = {9};
  CHECK(lab.source().bank_refused() == "golden run 1 fails in this build");
}

TEST_CASE("a bank without golden runs does not count") {
  Laboratory lab("no golden");
  lab.make_bank();
  FeatureBank bank = read_bank(*lab.options.bank);
  bank.golden.clear();
  write_bank(*lab.options.bank, bank);
  CHECK_THAT(lab.source().bank_refused(), Catch::Contains("has no golden run"));
}

TEST_CASE("a share of the bank's runs is computed again; one that was changed is named") {
  Laboratory lab("check");
  lab.make_bank();
  lab.options.check_share = 1.0;
  FeatureSource good = lab.source();
  good.features("noise", disc_runs(1, 6));
  good.features("again", disc_runs(1, 6));
  CHECK(good.cost().checked == 6);
  lab.options.check_share = 0.5;
  FeatureSource half = lab.source();
  half.features("noise", disc_runs(1, 6));
  CHECK(half.cost().checked > 0);
  CHECK(half.cost().checked < 6);
  FeatureBank bank = read_bank(*lab.options.bank);
  *bank.runs.at(bank_key(disc_config(4))).values[0] *= 1.0 + 1e-8;
  write_bank(*lab.options.bank, bank);
  lab.options.check_share = 1.0;
  FeatureSource bad = lab.source();
  try {
    bad.features("noise", disc_runs(1, 6));
    FAIL("a changed bank was believed");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::tolerance);
    CHECK(error.faults().at(0).where == "B, mesh 4");
  }
}

TEST_CASE("sources that share a store keep each other's runs") {
  Laboratory lab("shared");
  FeatureSource one = lab.source(), two = lab.source();
  one.features("a", disc_runs(1, 2));
  two.features("b", disc_runs(3, 4));
  FeatureSource three = lab.source();
  three.features("c", disc_runs(1, 4));
  CHECK(three.cost().from_store == 4);
}
