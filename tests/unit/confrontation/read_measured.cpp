#include "core/confrontation/read_measured.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>

#include "tests/unit/confrontation/measured_faults.hpp"

using namespace asperity;
using namespace asperity::measured;
using nlohmann::json;

TEST_CASE("a file with curves, numbers and both is read as the format has it") {
  const Folder folder("format");
  folder.put("T1.csv", "# from the logger\nspecimen,axial_strain,axial_stress_mpa,lateral_strain,acoustic_events\n" +
                           triangle("", 0.01, 1.0, "A,", ",0.001,3").substr(1) +
                           triangle("", 0.01, 1.2, "B,", ",0.001,4").substr(1));
  const MeasuredData data = folder.read(json::parse(R"({
    "material": "plaster", "source": "here", "licence": "CC0", "instrument": {"load_noise_percent": 0.1},
    "tests": [
     {"id": "T1", "experiment": "uniaxial", "width_mm": 54, "height_mm": 130, "closing_rate_mm_per_s": 10, "curve": "T1.csv",
      "scatter": "specimens", "instrument": {"displacement_zero_mm": 0.5}},
     {"id": "B1", "experiment": "brazilian", "diameter_mm": 54, "results": {"tensile_strength_mpa": [1.58, null, 1.66]}},
     {"id": "J1", "experiment": "direct_shear", "profile": [{"angle_deg": 30, "height_mm": 5}], "normal_stress_mpa": 1.47,
      "results": {"peak_shear_stress_kpa": 1790}, "use": "hold_out"}]})"));
  CHECK(data.name == "data");
  CHECK(data.material == "plaster");
  REQUIRE(data.tests.size() == 3);
  const MeasuredTest& t = data.tests[0];
  CHECK(specimens_of(t) == std::vector<std::string>{"A", "B"});
  CHECK(t.curves[1].lines.front() == 24);
  CHECK(t.curves[0].curve.events.back() == 3.0);
  CHECK(t.instrument.load_noise_percent == 0.1);
  CHECK(t.instrument.displacement_zero_mm == 0.5);
  CHECK(t.instrument.load_scale_percent == Instrument{}.load_scale_percent);
  CHECK(t.scatter == ScatterSource::specimens);
  CHECK(!t.use);
  CHECK(mean_of(t, "peak_axial_stress_mpa") == Approx(11.0).epsilon(1e-9));
  CHECK(mean_of(data.tests[1], "tensile_strength_mpa") == Approx(1.62));
  CHECK(data.tests[2].use == TestUse::hold_out);
  CHECK(mean_of(data.tests[2], "peak_shear_stress_mpa") == Approx(1.79));
  CHECK(data.tests[2].profile.front().angle_deg == 30.0);
}

TEST_CASE("columns may carry the usual units") {
  const auto [header, path, load] = GENERATE(table<std::string, double, double>({
      {"axial_strain,axial_stress_mpa", 0.01, 1.0},
      {"axial_strain_percent,axial_stress_kpa", 1.0, 1e3},
      {"axial_strain_microstrain,axial_stress_pa", 1e4, 1e6},
      {"axial_strain_permille,axial_stress_gpa", 10.0, 1e-3},
      {"axial_strain_mm_per_m,axial_stress_bar", 10.0, 10.0},
      {"axial_strain,axial_stress_n_per_mm2", 0.01, 1.0},
      {"axial_strain,axial_stress_kn_per_m2", 0.01, 1e3},
      {"axial_strain,axial_stress_psi", 0.01, 1.0 / 0.00689475729},
  }));
  CAPTURE(header);
  const Folder folder("units");
  folder.put("c.csv", triangle(header, path, load));
  const MeasuredData data = folder.read(uniaxial("c.csv"));
  CHECK(mean_of(data.tests[0], "peak_axial_stress_mpa") == Approx(10.0).epsilon(2e-3));
  CHECK(mean_of(data.tests[0], "peak_axial_strain") == Approx(0.01).epsilon(2e-3));
}

TEST_CASE("a disc's load may be a force over its thickness, a displacement in micrometres") {
  const Folder folder("force");
  folder.put("c.csv", triangle("platen_displacement_um,load_kn,note_room", 1e3, 0.25, "", ",warm"));
  json document = {
      {"tests",
       {{{"id", "B"}, {"experiment", "brazilian"}, {"diameter_mm", 50}, {"thickness_mm", 25}, {"curve", "c.csv"}}}}};
  const MeasuredData data = folder.read(document);
  CHECK(mean_of(data.tests[0], "peak_load_n_per_mm") == Approx(100.0));
  CHECK(mean_of(data.tests[0], "peak_closure_mm") == Approx(1.0));
  document["tests"][0].erase("thickness_mm");
  check_one(faults_of(folder, document), "c.csv", "a force needs the disc's thickness");
}

TEST_CASE("a gauge's strain is the path, or stands beside the platens'") {
  const Folder folder("gauge");
  folder.put("one.csv", triangle("axial_strain,axial_stress_mpa", 0.01));
  folder.put("two.csv", triangle("axial_strain,axial_stress_mpa,gauge_axial_strain", 0.01, 1.0, "", ",0.001"));
  json document = uniaxial("one.csv");
  CHECK_FALSE(path_is_gauge(folder.read(document).tests[0]));
  document["tests"][0]["axial_gauge_mm"] = 50;
  const MeasuredTest gauge = folder.read(document).tests[0];
  CHECK(path_is_gauge(gauge));
  CHECK(mean_of(gauge, "youngs_modulus_gpa") == Approx(1.0).epsilon(1e-6));
  document["tests"][0]["curve"] = "two.csv";
  CHECK_FALSE(path_is_gauge(folder.read(document).tests[0]));
}

TEST_CASE("a bad curve is one clear error") {
  const std::string head = "axial_strain,axial_stress_mpa";
  const std::string good = triangle(head, 0.01);
  const auto changed = [&](int line, const std::string& text) {
    std::string out;
    int at = 0;
    for (std::size_t i = 0, end; i < good.size(); i = end + 1) {
      end = good.find('\n', i);
      out += (++at == line ? text : good.substr(i, end - i)) + "\n";
    }
    return out;
  };
  const auto cut = [&](int lines) {
    std::size_t i = 0;
    for (int n = 0; n < lines; ++n) i = good.find('\n', i) + 1;
    return good.substr(0, i);
  };
  struct Bad {
    std::string text, where, what;
  };
  const std::vector<Bad> cases{
      {triangle("axial_strain,note_stress", 0.01), "c.csv", "the column axial_stress is missing"},
      {triangle("axial_strain,axial_stress_tons", 0.01), "c.csv", "the unit of a column is not known"},
      {triangle("axial_strain,axial_stress", 0.01), "c.csv", "the unit of a column is not known"},
      {triangle(head + ",axial_stress_kpa", 0.01, 1.0, "", ",1"), "c.csv", "given twice, in two units"},
      {triangle(head + ",latteral_strain", 0.01, 1.0, "", ",1"), "c.csv", "none of this experiment's"},
      {triangle(head, 1.0), "c.csv:22", "too large for a strain"},
      {triangle(head, 0.01, -1.0), "c.csv:12", "points the wrong way"},
      {triangle(head + ",lateral_strain", 0.01, 1.0, "", ",-0.001"), "c.csv:12", "negative at the peak"},
      {changed(5, "0.003,"), "c.csv:5", "no finite number"},
      {changed(5, "0.003,inf"), "c.csv:5", "no finite number"},
      {changed(5, "0.003,three"), "c.csv:5", "is no number"},
      {changed(8, "0.001,6.0"), "c.csv:8", "goes backwards without a reload"},
      {good + "0.005,0.1\n", "c.csv:23", "goes backwards without a reload"},
      {cut(12), "c.csv:12", "ends at its peak"},
      {cut(6), "c.csv:6", "too few rows"},
      {head + "\n", "c.csv", "has no rows"},
      {"", "c.csv", "has no header row"},
  };
  const Folder folder("bad");
  for (const Bad& bad : cases) {
    CAPTURE(bad.text);
    folder.put("c.csv", bad.text);
    check_one(faults_of(folder, uniaxial("c.csv")), bad.where, bad.what);
  }
  check_one(faults_of(folder, uniaxial("nowhere.csv")), "nowhere.csv", "No such file");
  folder.put("c.csv", cut(12));
  json stopped = uniaxial("c.csv");
  stopped["tests"][0]["ends_before_peak"] = true;
  CHECK(faults_of(folder, stopped).empty());
}

TEST_CASE("a reload is no fault, counts of events that fall are, a triaxial stress is total") {
  const Folder folder("loops");
  std::string text = "axial_strain,axial_stress_mpa\n";
  for (int i = 0; i <= 6; ++i) text += std::to_string(0.001 * i) + "," + std::to_string(i) + "\n";
  for (int i = 5; i > 1; --i) text += std::to_string(0.001 * i) + "," + std::to_string(i - 1) + "\n";
  for (int i = 2; i <= 6; ++i) text += std::to_string(0.001 * i) + "," + std::to_string(i - 1) + "\n";
  for (int i = 7; i <= 10; ++i) text += std::to_string(0.001 * i) + "," + std::to_string(i) + "\n";
  text += "0.011,5\n0.012,4\n";
  folder.put("c.csv", text);
  const MeasuredData data = folder.read(uniaxial("c.csv"));
  CHECK(mean_of(data.tests[0], "loop_count") == 1.0);
  folder.put("c.csv", triangle("acoustic_events,axial_strain,axial_stress_mpa", 0.01, 1.0, "5,") + "4,0.021,3.9\n");
  check_one(faults_of(folder, uniaxial("c.csv")), "c.csv:23", "acoustic_events falls");
  folder.put("c.csv", triangle("axial_strain,axial_stress_mpa", 0.01));
  json document = uniaxial("c.csv");
  document["tests"][0]["experiment"] = "triaxial";
  document["tests"][0]["confining_pressure_mpa"] = 2;
  check_one(faults_of(folder, document), "c.csv:2", "below the confining pressure");
}

TEST_CASE("a load cell's zero may lie a little below nothing") {
  const Folder folder("zero");
  folder.put("c.csv", triangle("axial_strain,axial_stress_mpa\n-0.0001,-0.03", 0.01));
  CHECK(faults_of(folder, uniaxial("c.csv")).empty());
}

TEST_CASE("a bad key is one clear error at its pointer") {
  using Change = std::function<void(json&)>;
  struct Bad {
    Change change;
    std::string where, what;
  };
  const std::vector<Bad> cases{
      {[](json& t) { t["hight_mm"] = 3; }, "/tests/0/hight_mm", "is not a key"},
      {[](json& t) { t["experiment"] = "bending"; }, "/tests/0/experiment", "not one of the allowed words"},
      {[](json& t) { t["diameter_mm"] = 3; }, "/tests/0/diameter_mm", "has no meaning in a test of type \"uniaxial\""},
      {[](json& t) { t["experiment"] = "triaxial"; }, "/tests/0/confining_pressure_mpa", "is missing"},
      {[](json& t) { t["height_mm"] = -3; }, "/tests/0/height_mm", "is out of range"},
      {[](json& t) { t["scatter"] = "specimens"; }, "/tests/0/scatter",
       "asks for the scatter of specimens, and there is one"},
      {[](json& t) { t["results"]["peak_axial_stres_mpa"] = 3; }, "/results/peak_axial_stres_mpa", "is no result"},
      {[](json& t) { t["results"]["peak_axial_stress_tons"] = 3; }, "/results/peak_axial_stress_tons",
       "unit of a result"},
      {[](json& t) { t["results"]["peak_axial_stress_mpa"] = "3"; }, "/results/peak_axial_stress_mpa",
       "no list of numbers"},
      {[](json& t) {
         t["results"]["poissons_ratio"] = {0.2, 0.3};
       },
       "/results/poissons_ratio", "another number of specimens"},
      {[](json& t) { t["results"]["peak_axial_stress_kpa"] = 3e3; }, "/results/peak_axial_stress_mpa",
       "given twice, in two units"},
      {[](json& t) { t.erase("results"); }, "/tests/0", "neither a curve nor results"},
      {[](json& t) {
         t = {{"id", "T"},
              {"experiment", "triaxial"},
              {"confining_pressure_mpa", 9},
              {"results", {{"peak_axial_stress_mpa", 7}}}};
       },
       "/tests/0/results/peak_axial_stress_mpa", "not above the confining pressure"},
  };
  const Folder folder("keys");
  for (const Bad& bad : cases) {
    json document = {
        {"tests", {{{"id", "U"}, {"experiment", "uniaxial"}, {"results", {{"peak_axial_stress_mpa", 7}}}}}}};
    bad.change(document["tests"][0]);
    CAPTURE(document.dump());
    check_one(faults_of(folder, document), bad.where, bad.what);
  }
  const json one = {{"id", "U"}, {"experiment", "uniaxial"}, {"results", {{"peak_axial_stress_mpa", 7}}}};
  check_one(faults_of(folder, {{"tests", {one, one}}}), "/tests/1/id", "the name of two tests");
  check_one(faults_of(folder, {{"tests", json::array()}}), "/tests", "wrong number of values");
  check_one(faults_of(folder, json::array()), "data.json", "must be an object");
}

TEST_CASE("all faults are told at once") {
  const Folder folder("all");
  folder.put("c.csv", triangle("axial_strain,axial_stress_tons", 0.01));
  json document = uniaxial("c.csv");
  document["tests"].push_back({{"id", "U"}, {"experiment", "brazilian"}, {"width_mm", 5}, {"curve", "gone.csv"}});
  std::vector<std::string> where;
  for (const Fault& fault : faults_of(folder, document)) where.push_back(fault.where);
  CHECK(where == std::vector<std::string>{folder.file("c.csv"), "/tests/1/width_mm", "/tests/1/diameter_mm",
                                          folder.file("gone.csv"), "/tests/1/id"});
}
