#include "core/confrontation/feature_bank.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "core/base/error.hpp"
#include "core/config/write_config.hpp"
#include "core/measurement/features.hpp"
#include "tests/unit/confrontation/fake_simulator.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

FeatureValues disc_values(double first) {
  FeatureValues values(feature_kinds(ExperimentType::brazilian).size());
  values[0] = first;
  values[3] = -1e-7;
  return values;
}

FeatureBank two_runs() {
  FeatureBank bank;
  for (const std::uint64_t seed : {1, 2})
    bank.runs[bank_key(disc_config(seed))] = {ExperimentType::brazilian,
                                              rounded(disc_values(1.0 / static_cast<double>(seed + 2)))};
  bank.golden.push_back({disc_config(3), disc_values(1.0 / 3.0)});
  return bank;
}

std::string fault_of(const std::string& text) {
  try {
    parse_bank(text, "bank.txt");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::config);
    return describe(error.faults().at(0));
  }
  return "";
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), with);
}

}  // namespace

TEST_CASE("a run's key is the beginning of its configuration's hash") {
  CHECK(bank_key(disc_config(5)) == config_hash(disc_config(5)).substr(0, 32));
}

TEST_CASE("nine digits stay, whatever is rounded again") {
  CHECK(rounded(1.0 / 3.0) == 0.333333333);
  CHECK(rounded(-123456789.6) == -123456790.0);
  CHECK(rounded(rounded(2e-17 / 3.0)) == rounded(2e-17 / 3.0));
  CHECK(rounded(FeatureValues{std::nullopt, 2.0 / 3.0}) == FeatureValues{std::nullopt, 0.666666667});
}

TEST_CASE("a bank is written and read back: runs to nine digits, golden runs to the last") {
  const FeatureBank bank = two_runs();
  const std::filesystem::path folder = std::filesystem::path(ASPERITY_TEST_SCRATCH) / "confrontation" / "bank";
  std::filesystem::create_directories(folder);
  write_bank(folder / "bank.txt", bank);
  const FeatureBank again = read_bank(folder / "bank.txt");
  CHECK(again.runs == bank.runs);
  REQUIRE(again.golden.size() == 1);
  CHECK(again.golden[0].values == bank.golden[0].values);
  CHECK(config_hash(again.golden[0].config) == config_hash(disc_config(3)));
  CHECK(bank_text(again) == bank_text(bank));
  CHECK(find_run(again, bank_key(disc_config(2)))->values == rounded(disc_values(0.25)));
  CHECK(find_run(again, bank_key(disc_config(9))) == nullptr);
}

TEST_CASE("merging adds what is missing and changes nothing else") {
  FeatureBank bank = two_runs(), more;
  more.runs[bank_key(disc_config(1))] = {ExperimentType::brazilian, disc_values(9.0)};
  more.runs[bank_key(disc_config(4))] = {ExperimentType::brazilian, disc_values(4.0)};
  merge(bank, more);
  CHECK(bank.runs.size() == 3);
  CHECK(find_run(bank, bank_key(disc_config(1)))->values[0] == rounded(1.0 / 3.0));
}

TEST_CASE("a damaged bank is refused at its line") {
  const std::string text = bank_text(two_runs());
  const std::string key = two_runs().runs.begin()->first;
  CHECK(fault_of(text).empty());
  CHECK_THAT(fault_of(replaced(text, "bank 1", "bank 2")), Catch::StartsWith("bank.txt:1: is no feature bank"));
  CHECK_THAT(fault_of(replaced(text, "peak_axial_strain", "peak_strain")),
             Catch::StartsWith("bank.txt:2: has other features"));
  CHECK_THAT(fault_of(replaced(text, "golden brazilian", "golden disc")),
             Catch::StartsWith("bank.txt:6: names no experiment"));
  CHECK_THAT(fault_of(replaced(text, "{\"name\"", "{\"nme\"")),
             Catch::StartsWith("bank.txt:6: has a configuration that is none"));
  CHECK_THAT(fault_of(replaced(text, key, "x" + key.substr(1))),
             Catch::StartsWith("bank.txt:7: does not begin with a run's key"));
  CHECK_THAT(fault_of(replaced(text, key + " brazilian ", key + " brazilian 7")), Catch::Equals(""));
  CHECK_THAT(fault_of(replaced(text, key + " brazilian ", key + " brazilian x")),
             Catch::StartsWith("bank.txt:7: has what is no number"));
  CHECK_THAT(fault_of(replaced(text, key + " brazilian ", key + " brazilian 7 ")),
             Catch::StartsWith("bank.txt:7: has 25 values"));
  CHECK_THAT(fault_of(text + text.substr(text.find(key))),
             Catch::StartsWith("bank.txt:9: has the key of an earlier line"));
  CHECK_THAT(fault_of(text.substr(0, text.size() - 1)), Catch::StartsWith("bank.txt: is cut off"));
  CHECK_THAT(fault_of(""), Catch::StartsWith("bank.txt: is cut off"));
}
