#include "core/confrontation/known_confusions.hpp"

#include <catch2/catch.hpp>

#include "tests/unit/confrontation/confrontation_folder.hpp"

using namespace asperity;
using nlohmann::json;

namespace {

MeasuredData without_gauge() {
  MeasuredTest test;
  SpecimenCurve specimen;
  specimen.curve.path = {0.0, 0.01};
  specimen.curve.load = {0.0, 5.0};
  test.curves.push_back(specimen);
  MeasuredData data;
  data.tests.push_back(test);
  return data;
}

std::string only(const std::vector<std::string>& sentences) { return sentences.size() == 1 ? sentences.front() : ""; }

}  // namespace

TEST_CASE("causes that are known to be taken for one another are told with the test that parts them") {
  const MeasuredData data = without_gauge();
  CHECK(only(known_confusions({"crack_closure", "damping", "seating"}, data)).find("unloading") != std::string::npos);
  CHECK(only(known_confusions({"strength_scatter", "weak_plane"}, data)).find("another direction") !=
        std::string::npos);
  CHECK(known_confusions({"seating"}, data).empty());
  CHECK(known_confusions({"seating", "weak_plane"}, data).empty());
}

TEST_CASE("a soft frame is confused with a soft rock only where no gauge is on the specimen") {
  MeasuredData data = without_gauge();
  CHECK(only(known_confusions({"frame_compliance"}, data)).find("gauge") != std::string::npos);
  data.tests[0].curves[0].curve.gauge_strain = {0.0, 0.01};
  CHECK(known_confusions({"frame_compliance"}, data).empty());
  data = without_gauge();
  data.tests[0].results["youngs_modulus_gpa"] = {1.3};
  CHECK(known_confusions({"frame_compliance"}, data).empty());
}

TEST_CASE("settings of the solver that are no candidates are remembered") {
  testing::ConfrontationFolder folder("left_out_suspects");
  json document = testing::confrontation();
  CHECK(folder.read(document).left_out_suspects.empty());
  document["without"] = {"damping"};
  CHECK(folder.read(document).left_out_suspects == std::vector<std::string>{"damping"});
  document.erase("without");
  document["mechanisms"] = {"seating", "loading_rate"};
  CHECK(folder.read(document).left_out_suspects == std::vector<std::string>{"damping", "mesh_size", "plane_condition"});
}
