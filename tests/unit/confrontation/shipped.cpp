#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

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
