#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "core/config/schema_lookup.hpp"
#include "core/measurement/features.hpp"
#include "tests/unit/confrontation/measured_faults.hpp"

using namespace asperity;
using namespace asperity::measured;
using nlohmann::json;

namespace {

json test_of(const std::string& experiment) {
  json test = {{"id", "T"}, {"experiment", experiment}};
  if (experiment == "direct_shear") test["normal_stress_mpa"] = 1;
  if (experiment == "brazilian") test.update({{"diameter_mm", 50}, {"thickness_mm", 25}});
  return test;
}

json with_result(const std::string& experiment, const std::string& name, const json& value) {
  json test = test_of(experiment);
  test["results"][name] = value;
  return {{"tests", {test}}};
}

json with_curve(const std::string& experiment) {
  json test = test_of(experiment);
  test["curve"] = "c.csv";
  return {{"tests", {test}}};
}

/// The test's curves read, each feature as a list over its specimens.
json features_as_results(const MeasuredTest& test) {
  json results = json::object();
  const auto kinds = feature_kinds(test.experiment);
  for (const SpecimenCurve& specimen : test.curves) {
    const std::vector<FeatureValue> values = read_features(specimen.curve, reading_of(test));
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      const auto& value = values[k].value;
      results[std::string(kinds[k].name)].push_back(value ? json(*value) : json());
    }
  }
  return results;
}

}  // namespace

TEST_CASE("a result that cannot be is one clear error at its pointer") {
  struct Bad {
    std::string experiment, name;
    double value;
    std::string what;
  };
  const std::vector<Bad> cases{
      {"uniaxial", "peak_axial_stress_mpa", -7.0, "cannot be 0 or below"},
      {"uniaxial", "peak_axial_stress_psi", 0.0, "cannot be 0 or below"},
      {"uniaxial", "youngs_modulus_gpa", 0.0, "cannot be 0 or below"},
      {"uniaxial", "peak_axial_strain", -0.003, "cannot be 0 or below"},
      {"uniaxial", "peak_axial_strain", 0.6, "too large for a strain"},
      {"uniaxial", "peak_axial_strain_percent", 60.0, "too large for a strain"},
      {"uniaxial", "peak_lateral_strain", -0.6, "too large for a strain"},
      {"uniaxial", "peak_axial_stress_gpa", 1.1e3, "too large for a stress"},
      {"uniaxial", "residual_axial_stress_mpa", -1.1e6, "too large for a stress"},
      {"uniaxial", "axial_modulus_mpa", 1.1e7, "too large for a modulus"},
      {"uniaxial", "poissons_ratio", 1e200, "too large for such a number"},
      {"uniaxial", "drop_share", 30.0, "is no share"},
      {"uniaxial", "event_share_at_half", -0.1, "is no share"},
      {"uniaxial", "toe_extent_share", 20.0, "is no share"},
      {"uniaxial", "events_at_peak", -1.0, "cannot be below 0"},
      {"uniaxial", "loop_count", -2.0, "cannot be below 0"},
      {"brazilian", "peak_load_n_per_mm", 1e200, "too large for a load over thickness"},
      {"brazilian", "stiffness_n_per_mm2", -200.0, "cannot be 0 or below"},
      {"brazilian", "peak_closure_m", 1.1e3, "too large for a length"},
      {"direct_shear", "peak_shear_stress_mpa", 0.0, "cannot be 0 or below"},
      {"direct_shear", "shear_stiffness_mpa_per_mm", -3.0, "cannot be 0 or below"},
      {"direct_shear", "largest_drop_mpa", -1.0, "cannot be below 0"},
  };
  const Folder folder("results");
  for (const Bad& bad : cases)
    check_one(faults_of(folder, with_result(bad.experiment, bad.name, bad.value)), "/tests/0/results/" + bad.name,
              bad.what);
}

TEST_CASE("of a list the first value that cannot be is named, as it was written") {
  const Folder folder("list");
  const json document = with_result("uniaxial", "peak_axial_strain_percent", {0.3, nullptr, 60, 70});
  const std::vector<Fault> faults = faults_of(folder, document);
  check_one(faults, "/tests/0/results/peak_axial_strain_percent/2", "too large for a strain");
  CHECK(faults.front().value == "60");
  CHECK(faults.front().allowed == "up to 50");
}

TEST_CASE("a strength that cannot be is not held against the confining pressure too") {
  const Folder folder("once");
  json document = with_result("triaxial", "peak_axial_stress_mpa", -7);
  document["tests"][0]["confining_pressure_mpa"] = 2;
  check_one(faults_of(folder, document), "/results/peak_axial_stress_mpa", "cannot be 0 or below");
}

TEST_CASE("what is odd but possible is a result") {
  const std::vector<json> documents{
      with_result("uniaxial", "residual_axial_stress_mpa", 0),
      with_result("uniaxial", "toe_offset_strain", -0.001),
      with_result("uniaxial", "peak_lateral_strain", {-0.002, 0.002}),
      with_result("uniaxial", "poissons_ratio", {1.2, -0.1}),
      with_result("uniaxial", "drop_share", {0, 1, nullptr}),
      with_result("uniaxial", "events_at_peak", 2e6),
      with_result("uniaxial", "loop_count", 0),
      with_result("brazilian", "toe_travel_mm", -0.02),
      with_result("direct_shear", "end_dilation_mm", -0.3),
      with_result("direct_shear", "rise_after_drop_mpa", 0),
  };
  const Folder folder("possible");
  for (const json& document : documents) {
    CAPTURE(document.dump());
    CHECK(faults_of(folder, document).empty());
  }
}

TEST_CASE("what a curve gives may be a result") {
  const fs::path file = fs::path(ASPERITY_SOURCE_DIR) / "configs/measured/laboratory.json";
  const MeasuredData data = read_measured_data(file);
  std::ifstream in(file);
  json document = json::parse(in);
  for (std::size_t i = 0; i < data.tests.size(); ++i) {
    json& test = document["tests"][i];
    REQUIRE(!data.tests[i].curves.empty());
    test.erase("curve");
    test["results"] = features_as_results(data.tests[i]);
  }
  CHECK(faults_of(Folder("given"), document).empty());
}

TEST_CASE("results are as many as the curves' specimens") {
  const Folder folder("count");
  folder.put("c.csv",
             triangle("specimen,axial_strain,axial_stress_mpa", 0.01, 1.0, "A,") + triangle("# B", 0.01, 1.0, "B,"));
  json document = uniaxial("c.csv");
  document["tests"][0]["results"]["youngs_modulus_gpa"] = 1.3;
  check_one(faults_of(folder, document), "/results/youngs_modulus_gpa", "fewer specimens than the curves");
  for (const json& values : {json{1.3, nullptr}, json{1.3, 1.2, 1.4}}) {
    document["tests"][0]["results"]["youngs_modulus_gpa"] = values;
    CHECK(faults_of(folder, document).empty());
  }
  document["tests"][0]["results"]["poissons_ratio"] = {0.2, 0.3};
  check_one(faults_of(folder, document), "/results/youngs_modulus_gpa", "than the results before it");
}

TEST_CASE("a reading that no instrument gives is one clear error") {
  const std::string head = "axial_strain,axial_stress_mpa";
  struct Bad {
    std::string experiment, text, where, what;
  };
  const std::vector<Bad> cases{
      {"uniaxial", triangle(head + ",gauge_axial_strain", 0.01, 1.0, "", ",0.9"), "c.csv:2",
       "gauge_axial_strain is too large for a strain"},
      {"uniaxial", triangle(head + ",lateral_strain", 0.01, 1.0, "", ",-0.9"), "c.csv:2",
       "lateral_strain is too large for a strain"},
      {"uniaxial", triangle("acoustic_events," + head, 0.01, 1.0, "-3,"), "c.csv:2", "acoustic_events is negative"},
      {"uniaxial", triangle("axial_strain,axial_stress_gpa", 0.01, 1e3), "c.csv:12", "too large for a stress"},
      {"brazilian", triangle("platen_displacement_mm,load_kn", 1.0, 1e200), "c.csv:12",
       "too large for a load over thickness"},
      {"direct_shear", triangle("shear_displacement_m,shear_stress_mpa", 1e4), "c.csv:22", "too large for a length"},
  };
  const Folder folder("sizes");
  for (const Bad& bad : cases) {
    folder.put("c.csv", bad.text);
    check_one(faults_of(folder, with_curve(bad.experiment)), bad.where, bad.what);
  }
}

TEST_CASE("a gauge may go over its range once the specimen is broken") {
  const Folder folder("over_range");
  folder.put("c.csv",
             triangle("axial_strain,axial_stress_mpa,lateral_strain", 0.01, 1.0, "", ",0.001") + "0.021,0.1,0.9\n");
  CHECK(faults_of(folder, with_curve("uniaxial")).empty());
}

TEST_CASE("a gauge's percentage under the wrong name is told once") {
  const Folder folder("percent");
  folder.put("c.csv", triangle("axial_strain,axial_stress_mpa", 1.0));
  json document = uniaxial("c.csv");
  document["tests"][0]["axial_gauge_mm"] = 50;
  check_one(faults_of(folder, document), "c.csv:22", "axial_strain is too large for a strain");
}

TEST_CASE("a gauge is no longer than its specimen") {
  const Folder folder("gauge_length");
  folder.put("c.csv", triangle("axial_strain,axial_stress_mpa", 0.01));
  json document = uniaxial("c.csv");
  document["tests"][0]["axial_gauge_mm"] = 120;
  check_one(faults_of(folder, document), "/tests/0/axial_gauge_mm", "longer than the specimen");
  document["tests"][0]["axial_gauge_mm"] = 100;
  CHECK(faults_of(folder, document).empty());
}

TEST_CASE("a table in another encoding or with other separators is one clear error") {
  const Folder folder("table");
  folder.put("c.csv", triangle("specimen,axial_strain,axial_stress_mpa", 0.01, 1.0,
                               "Pr\xfc"
                               "f1,"));
  check_one(faults_of(folder, uniaxial("c.csv")), "c.csv:2", "no UTF-8 text");
  folder.put("c.csv", "axial_strain;axial_stress_mpa\n0;0\n0,001;1,5\n");
  check_one(faults_of(folder, uniaxial("c.csv")), "c.csv:1", "separated by semicolons");
}

TEST_CASE("a specimen column that counts rows is one error") {
  std::string text = "specimen,axial_strain,axial_stress_mpa\n";
  for (int row = 0; row < 50000; ++row) text += std::to_string(row) + ",0.001,1\n";
  const Folder folder("counter");
  folder.put("c.csv", text);
  const std::vector<Fault> faults = faults_of(folder, uniaxial("c.csv"));
  check_one(faults, "c.csv", "every specimen has too few rows");
  CHECK(faults.front().value == "50000 specimens in 50000 rows");
}

TEST_CASE("the schema allows as many tests and rows left out as the reader") {
  const json& schema = parsed_schema("measured");
  const Folder folder("many");
  for (const std::string list : {"tests", "left_out"}) {
    const std::size_t most = schema.at("properties").at(list).at("maxItems");
    json document = with_result("uniaxial", "loop_count", 0);
    json& entries = document[list];
    while (entries.size() < most) {
      entries.push_back(test_of("uniaxial"));
      entries.back().update({{"id", std::to_string(entries.size())}, {"results", {{"loop_count", 0}}}});
    }
    CHECK(faults_of(folder, document).empty());
    entries.push_back(entries.front());
    check_one(faults_of(folder, document), "/" + list + "/" + std::to_string(most), "one value too many");
  }
}
