#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core/confrontation/feature_bank.hpp"
#include "core/confrontation/golden_runs.hpp"
#include "core/confrontation/read_measured.hpp"

using namespace asperity;
using nlohmann::json;

namespace fs = std::filesystem;

TEST_CASE("the shipped measured files hold every row of their sources") {
  const fs::path configs = fs::path(ASPERITY_SOURCE_DIR) / "configs/measured";
  const std::map<std::string, int> rows{
      {"zigong_sandstone", 41}, {"berea_sandstone", 45}, {"carrara_marble", 32}, {"dunnville_sandstone", 19}};
  for (const auto& [name, count] : rows) {
    const fs::path file = configs / (name + ".json");
    const MeasuredData data = read_measured_data(file);
    std::size_t held = 0;
    for (const MeasuredTest& test : data.tests) held += specimens_of(test).size();
    std::ifstream in(file);
    const json document = json::parse(in);
    CAPTURE(name);
    CHECK(held + document.value("left_out", json::array()).size() == static_cast<std::size_t>(count));
    CHECK(!data.licence.empty());
    CHECK(!data.source.empty());
  }
}

TEST_CASE("the shipped bank is known by every kind of test and every mechanism of its confrontation") {
  const fs::path configs = fs::path(ASPERITY_SOURCE_DIR) / "configs/confrontation";
  const ConfrontationConfig config = read_confrontation(configs / "laboratory.json", {});
  const std::vector<RunConfig> runs = golden_runs(config);
  std::set<std::string> mechanisms;
  std::set<ExperimentType> bare;
  for (const RunConfig& run : runs) {
    for (const MechanismConfig& m : run.mechanisms) mechanisms.insert(m.type);
    if (run.mechanisms.empty()) bare.insert(run.experiment.type);
  }
  CHECK(mechanisms == std::set<std::string>(config.mechanisms.begin(), config.mechanisms.end()));
  CHECK(bare.size() == 4);
  REQUIRE(config.bank.has_value());
  const FeatureBank bank = read_bank(*config.bank);
  std::set<std::string> held, made;
  for (const GoldenRun& golden : bank.golden) held.insert(bank_key(golden.config));
  for (const RunConfig& run : runs) made.insert(bank_key(run));
  CHECK(held == made);
}
