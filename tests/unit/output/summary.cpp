#include "core/output/summary.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"
#include "tests/unit/output/scratch.hpp"

using namespace asperity;
using asperity::testing::fresh_folder;

TEST_CASE("a summary keeps the order of its keys and reads back") {
  const auto path = fresh_folder("summary") / "summary.json";
  Summary summary;
  summary.experiment = {{"type", "brazilian"}, {"name", "quickstart"}};
  summary.results = {{"tensile_strength_mpa", 1.61}, {"peak_axial_strain", 0.01}};
  summary.warnings = {"one"};
  write_summary(path, summary);
  CHECK_THAT(
      read_file(path),
      Catch::Contains("{\n  \"experiment\": {\n    \"type\": \"brazilian\",\n    \"name\": \"quickstart\"\n  },\n"
                      "  \"results\": {\n    \"tensile_strength_mpa\": 1.61,\n    \"peak_axial_strain\": 0.01\n"
                      "  },\n  \"energy\": {},\n  \"cracks\": {},\n  \"failure_mode\": {},\n  \"contacts\": {},\n  "
                      "\"cost\": {},\n  \"warnings\": ["));
  const Summary back = read_summary(path);
  CHECK(back.results == summary.results);
  CHECK(back.warnings == summary.warnings);
}

TEST_CASE("a file that is no summary is told by its path") {
  const auto path = fresh_folder("summary_bad") / "summary.json";
  write_file_atomically(path, "{\"experiment\": {}}");
  CHECK_THROWS_WITH(read_summary(path), Catch::Contains("summary.json: is no summary"));
  write_file_atomically(path, "{");
  CHECK_THROWS_AS(read_summary(path), Error);
}

TEST_CASE("a summary whose section is no object is told by the section") {
  const std::string text =
      R"({"experiment": {}, "results": 1, "energy": {}, "cracks": {}, "contacts": {}, "cost": {}, "warnings": []})";
  CHECK_THROWS_WITH(parse_summary(text, "summary.json"), Catch::Contains("\"results\" is no object"));
}

TEST_CASE("a summary of before the failure mode was told is read, a failure mode that is no object is not") {
  const std::string head = R"({"experiment": {}, "results": {}, "energy": {}, "cracks": {}, "contacts": {}, )";
  const std::string tail = R"("cost": {}, "warnings": []})";
  CHECK(parse_summary(head + tail, "summary.json").failure_mode == nlohmann::ordered_json::object());
  const Summary told = parse_summary(head + R"("failure_mode": {"at_end": {"splits": true}}, )" + tail, "summary.json");
  CHECK(told.failure_mode["at_end"]["splits"] == true);
  CHECK_THROWS_WITH(parse_summary(head + R"("failure_mode": [], )" + tail, "summary.json"),
                    Catch::Contains("\"failure_mode\" is no object"));
}

TEST_CASE("brackets nested without end are told, not followed") {
  const std::string text = "{\"experiment\": " + std::string(200000, '[') + std::string(200000, ']') + "}";
  CHECK_THROWS_WITH(parse_summary(text, "summary.json"),
                    Catch::Contains("summary.json: has brackets nested too deeply"));
}
