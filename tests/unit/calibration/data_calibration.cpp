#include "core/calibration/data_calibration.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "core/base/error.hpp"
#include "core/calibration/data_procedure.hpp"
#include "tests/unit/calibration/examples.hpp"

using namespace asperity;
namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

ordered_json table4_config() { return ordered_json::parse(std::ifstream(examples::kTable4)); }

/// A folder with this config and Table 4's runs, `edit` applied to the table's text.
fs::path put(
    const std::string& name, const ordered_json& config,
    const std::function<void(std::string&)>& edit = [](std::string&) {}) {
  const fs::path folder = fs::path(ASPERITY_TEST_SCRATCH) / "data_calibration" / name;
  fs::create_directories(folder);
  std::ifstream stream(examples::kTable4.parent_path() / "paper_table4.csv");
  std::string table((std::istreambuf_iterator<char>(stream)), {});
  edit(table);
  std::ofstream(folder / "paper_table4.csv") << table;
  std::ofstream(folder / "config.json") << config.dump(1);
  return folder / "config.json";
}

std::string message_of(const std::string& name, const ordered_json& config) {
  try {
    read_data_calibration(put(name, config));
    return {};
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::config);
    return error.what();
  }
}

}  // namespace

TEST_CASE("calibration.json of Table 4 has the agreed keys in order") {
  const fs::path folder = fs::path(ASPERITY_TEST_SCRATCH) / "data_calibration" / "out";
  fs::create_directories(folder);
  calibrate_data(examples::kTable4, folder);
  const ordered_json json = ordered_json::parse(std::ifstream(folder / "calibration.json"));
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  CHECK(keys == std::vector<std::string>{"name", "kind", "targets", "elastic", "design", "responses", "bad_runs",
                                         "models", "rounds", "solutions", "compromise", "routes", "parameters",
                                         "configs", "verification", "failure_mode", "trade_off", "cost", "warnings"});
  CHECK(json["kind"] == "data");
  CHECK(json["design"]["coded"].size() == 20);
  CHECK(json["design"]["kind"][8] == "star");
  CHECK(json["design"]["alpha"] == 1.682);
  CHECK(json["responses"]["cohesion_mpa"][1] == 1.91);
  const ordered_json& model = json["models"]["friction_angle_deg"];
  CHECK(model["coefficients"]["x1^2"].get<double>() == Approx(-0.75).margin(0.006));
  CHECK(model["coefficients"]["x1x2"].get<double>() == Approx(5.43).margin(0.006));
  CHECK(model["anova"].front()["source"] == "model");
  CHECK(model["anova"].back()["f"].is_null());
  CHECK(model["fitted"].size() == 20);
  CHECK(json["solutions"].is_array());
  CHECK(json["solutions"].empty());
  CHECK(json["parameters"].is_null());
  CHECK(json["compromise"]["region"]["determined"].size() == 3);
  CHECK(json["compromise"]["predicted"].contains("tensile_strength_mpa"));
}

TEST_CASE("the same config gives the same bytes again") {
  std::string bytes[2];
  for (std::string& text : bytes) {
    const DataCalibration c = read_data_calibration(examples::kTable4);
    text = calibration_json(c, analyse(c.design, c.responses, c.targets, c.options)).dump();
  }
  CHECK(bytes[0] == bytes[1]);
}

TEST_CASE("an empty cell is a bad run, named and left out") {
  const fs::path config = put("hole", table4_config(), [](std::string& table) {
    const std::size_t place = table.find(",0.47,");
    table.replace(place, 6, ",,");
  });
  const DataCalibration c = read_data_calibration(config);
  REQUIRE(c.responses.bad_runs.size() == 1);
  CHECK(c.responses.bad_runs[0].row == 1);
  CHECK(c.responses.bad_runs[0].test == "tensile_strength_mpa");
  const Analysis analysis = analyse(c.design, c.responses, c.targets, c.options);
  const ordered_json json = calibration_json(c, analysis);
  CHECK(json["responses"]["tensile_strength_mpa"][1].is_null());
  CHECK(json["models"]["tensile_strength_mpa"]["fitted"][1].is_null());
  CHECK(json["models"]["cohesion_mpa"]["fitted"][1].is_number());
  CHECK(json["bad_runs"][0]["treatment"] == "left out of this response's model");
  CHECK_THAT(analysis.warnings.at(0), Catch::Contains("bad runs in design rows 2"));
}

TEST_CASE("what is wrong with a config is told all at once, each with its pointer") {
  ordered_json config = table4_config();
  config["targets"]["cohesion_mpa"]["value"] = "much";
  config["targets"]["friction_angle_deg"]["tolerance"] = -0.05;
  config["factors"][1].erase("centre");
  config["factors"][2]["scale"] = "cubic";
  config["analysis"]["elimination_level"] = 0;
  config["analysis"]["region"] = "circle";
  const std::string message = message_of("faults", config);
  CHECK_THAT(message, Catch::Contains("/targets/cohesion_mpa/value: is no number (found \"much\""));
  CHECK_THAT(message,
             Catch::Contains("/targets/friction_angle_deg/tolerance: is out of range (found -0.05; allowed: above 0)"));
  CHECK_THAT(message, Catch::Contains("/factors/1/centre: is missing"));
  CHECK_THAT(
      message,
      Catch::Contains(
          "/factors/2/scale: is not one of the allowed words (found \"cubic\"; allowed: \"linear\", \"logarithmic\")"));
  CHECK_THAT(message, Catch::Contains("/analysis/elimination_level: is out of range"));
  CHECK_THAT(message, Catch::Contains("/analysis/region: is not one of the allowed words"));
}

TEST_CASE("a target that no response has, and a wrong table, are one clear error each") {
  ordered_json config = table4_config();
  config["targets"]["cohesoin_mpa"] = {{"value", 1.0}};
  const DataCalibration c = read_data_calibration(put("unknown", config));
  CHECK_THROWS_WITH(analyse(c.design, c.responses, c.targets, c.options),
                    Catch::Contains("/targets/cohesoin_mpa: no response has this name") &&
                        Catch::Contains("did you mean cohesion_mpa?"));
  config = table4_config();
  config["data"]["response_columns"]["cohesion_mpa"] = "C_MPa";
  CHECK_THAT(message_of("column", config), Catch::Contains("paper_table4.csv: no column \"C_MPa\""));
  config = table4_config();
  config["data"]["coded_columns"] = {"x1", "x2"};
  CHECK_THAT(message_of("columns", config), Catch::Contains("/data/coded_columns: has not one column a factor"));
  config = table4_config();
  config["published"]["equations"]["cohesion_mpa"]["terms"][3] = {"x4", "0.15"};
  CHECK_THAT(message_of("term", config),
             Catch::Contains("/published/equations/cohesion_mpa/terms/3: is no printed term"));
  config = table4_config();
  config.erase("data");
  CHECK_THAT(message_of("no data", config), Catch::Contains("/data: is missing"));
}

TEST_CASE("keys of the analysis reach the options") {
  ordered_json config = table4_config();
  config["analysis"] = {{"elimination_level", 0.1},
                        {"hierarchical", false},
                        {"region", "cube"},
                        {"desirability_half_range", 0.5},
                        {"desirability_exponent", 2},
                        {"starts", 10},
                        {"cluster_radius", 0.2},
                        {"level", 0.9},
                        {"most_move", 0.5},
                        {"bootstrap_draws", 20},
                        {"seed", 9}};
  config["data"]["response_columns"]["cohesion_mpa"] = {{"column", "cohesion_mpa"}, {"transform", "logarithm"}};
  const DataCalibration c = read_data_calibration(put("options", config));
  CHECK(c.options.model.elimination_level == 0.1);
  CHECK(c.options.model.hierarchy == Hierarchy::free);
  CHECK(c.options.region == RegionShape::cube);
  CHECK(c.options.search.desirability.half_range == 0.5);
  CHECK(c.options.search.desirability.exponent == 2.0);
  CHECK(c.options.search.starts == 10);
  CHECK(c.options.search.cluster_radius == 0.2);
  CHECK(c.options.level == 0.9);
  CHECK(c.options.most_move == 0.5);
  CHECK(c.options.bootstrap_draws == 20);
  CHECK(c.options.seed == 9);
  CHECK(c.responses.list[1].transform == Transform::logarithm);
}
