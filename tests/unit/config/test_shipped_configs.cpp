#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "core/config/estimates.hpp"
#include "core/config/write_config.hpp"
#include "fault_finder.hpp"

using namespace asperity;
using namespace asperity::test;
namespace fs = std::filesystem;

namespace {

const fs::path kConfigs = fs::path(ASPERITY_SOURCE_DIR) / "configs";

std::vector<fs::path> json_files(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  return files;
}

std::vector<fs::path> shipped() {
  std::vector<fs::path> files = json_files(kConfigs);
  for (const char* folder : {"paper", "acceleration", "plaster"})
    for (const fs::path& file : json_files(kConfigs / folder)) files.push_back(file);
  return files;
}

std::string message_of(const fs::path& file) {
  try {
    read_run_config(file);
    return {};
  } catch (const Error& error) {
    return error.what();
  }
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) c == ',' ? (void)cells.emplace_back() : (void)cells.back().push_back(c);
  return cells;
}

std::vector<std::vector<std::string>> index_rows() {
  std::ifstream file(kConfigs / "paper" / "index.csv");
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(file, line);) rows.push_back(split(line));
  return rows;
}

}  // namespace

TEST_CASE("every shipped configuration is read without a fault and reads back from its effective form") {
  CHECK(shipped().size() >= 11);
  for (const fs::path& file : shipped()) {
    INFO(file);
    CHECK(message_of(file) == "");
    const RunConfig config = read_run_config(file);
    CHECK(parse_run_config(effective_json(config), "x") == config);
  }
}

TEST_CASE("every shipped configuration has its schema, its file's name and a description") {
  for (const fs::path& file : shipped()) {
    INFO(file);
    std::ifstream stream(file);
    const nlohmann::json document = nlohmann::json::parse(stream);
    CHECK(fs::equivalent(file.parent_path() / document.at("$schema").get<std::string>(),
                         kConfigs / "schema" / "run.schema.json"));
    CHECK(document.at("name") == file.stem().string());
    CHECK(document.at("description").get<std::string>().size() > 20);
  }
}

TEST_CASE("the paper's configurations have its specimens and Table 5") {
  const std::map<std::string, ExperimentType> types{{"brazilian", ExperimentType::brazilian},
                                                    {"uniaxial", ExperimentType::uniaxial},
                                                    {"triaxial_0.5", ExperimentType::triaxial},
                                                    {"triaxial_1.0", ExperimentType::triaxial}};
  for (const auto& [name, type] : types) {
    for (const std::string ending : {"", "_literal"}) {
      INFO(name + ending);
      const RunConfig c = read_run_config(kConfigs / "paper" / (name + ending + ".json"));
      const bool disc = type == ExperimentType::brazilian;
      CHECK(c.experiment.type == type);
      CHECK(c.experiment.plane == (disc ? PlaneCondition::stress : PlaneCondition::strain));
      CHECK((disc ? c.experiment.diameter_mm : c.experiment.width_mm) == 54.0);
      CHECK((disc || c.experiment.height_mm == 130.0));
      CHECK(c.experiment.confining_pressure_mpa == (name == "triaxial_0.5" ? 0.5 : name == "triaxial_1.0" ? 1.0 : 0.0));
      CHECK(c.contacts.tensile_strength_mpa == 6.89);
      CHECK(c.contacts.cohesion_mpa == 5.02);
      CHECK(c.contacts.friction_angle_deg == 36.5);
      CHECK(c.particles.youngs_modulus_gpa == 1.3);
      CHECK(c.particles.poissons_ratio == 0.2);
      CHECK(c.particles.edge_mm == 2.0);
      CHECK(estimated_tensile_stiffness(c) == Approx(disc ? 2500.0 : 2610.0).epsilon(2e-3));  // Table 5, three digits
      CHECK(c.contacts.law == LawConfig{ending.empty() ? LawReading::consistent : LawReading::literal, {}, {}, {}});
    }
  }
}

TEST_CASE("index.csv names shipped configurations, and every configuration of the paper") {
  const auto rows = index_rows();
  REQUIRE(rows.size() > 1);
  CHECK(rows[0] == std::vector<std::string>{"config", "paper_reference", "quantity", "printed_value", "unit"});
  std::map<std::string, int> named;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    INFO(i);
    REQUIRE(rows[i].size() == 5);
    CHECK(fs::exists(kConfigs / "paper" / rows[i][0]));
    ++named[rows[i][0]];
  }
  for (const fs::path& file : json_files(kConfigs / "paper")) CHECK(named[file.filename().string()] > 0);
}
