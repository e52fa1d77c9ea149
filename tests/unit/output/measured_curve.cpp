#include "core/output/measured_curve.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <numbers>

#include "core/base/error.hpp"
#include "core/config/read_config.hpp"
#include "core/config/write_config.hpp"
#include "tests/unit/output/scratch.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

/// A configuration of the experiment with a measured file of this text beside it.
RunConfig config_with(ExperimentType type, const std::string& text) {
  const auto file = fresh_folder("measured_curve") / "lab.csv";
  std::ofstream(file) << text;
  RunConfig config;
  config.experiment.type = type;
  config.output.measured_curve = file.string();
  config.output.measured_name = "lab";
  return config;
}

std::vector<MeasuredCurve> curves(ExperimentType type, const std::string& text) {
  return read_measured_curves(config_with(type, text));
}

std::string refusal(ExperimentType type, const std::string& text) {
  try {
    curves(type, text);
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::config);
    return error.what();
  }
  return "accepted";
}

constexpr const char* kJointRun =
    R"({"experiment": {"type": "direct_shear", "normal_stress_mpa": 1}, "output": {"measured_curve": "lab.csv"}})";

std::string parse_refusal(const std::string& text, const std::string& origin) {
  try {
    parse_run_config(text, origin);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("A joint's measured curve is taken as it stands; what is not measured is NaN") {
  const auto all = curves(ExperimentType::direct_shear,
                          "# digitised\nshear_displacement_mm,shear_stress_mpa,dilation_mm\n0.5,1.25,0.1\n1,1.5,\n");
  REQUIRE(all.size() == 1);
  CHECK(all[0].name == "lab");
  CHECK(all[0].abscissa == std::vector<double>{0.5, 1.0});
  CHECK(all[0].stress_mpa == std::vector<double>{1.25, 1.5});
  CHECK(all[0].dilation_mm[0] == 0.1);
  CHECK(std::isnan(all[0].dilation_mm[1]));
  CHECK(std::isnan(all[0].dilation_rear_mm[0]));
}

TEST_CASE("A disc's displacement and load become the strain and stress of its curve") {
  RunConfig config = config_with(ExperimentType::brazilian, "platen_displacement_mm,load_n_per_mm\n0.54,100\n");
  config.experiment.diameter_mm = 54;
  const auto all = read_measured_curves(config);
  CHECK(all.at(0).abscissa.at(0) == Approx(0.01));
  CHECK(all.at(0).stress_mpa.at(0) == Approx(200.0 / (std::numbers::pi * 54.0)));
}

TEST_CASE("Specimens become curves of their own, in the order of the file") {
  const auto all =
      curves(ExperimentType::triaxial,
             "specimen,axial_strain,axial_stress_mpa,lateral_strain\nB,0.001,2,0.0001\nA,0.002,3,0\nB,0.003,4,0\n");
  REQUIRE(all.size() == 2);
  CHECK(all[0].name == "lab, B");
  CHECK(all[0].stress_mpa == std::vector<double>{2.0, 4.0});
  CHECK(all[0].lateral_strain[0] == 0.0001);
  CHECK(all[1].name == "lab, A");
  CHECK(all[1].abscissa == std::vector<double>{0.002});
}

TEST_CASE("A measured file without its columns, rows or numbers is refused with its place") {
  const std::string missing = refusal(ExperimentType::direct_shear, "axial_strain,axial_stress_mpa\n0,1\n");
  CHECK_THAT(missing, Catch::Contains("lab.csv") && Catch::Contains("no column \"shear_displacement_mm\"") &&
                          Catch::Contains("no column \"shear_stress_mpa\"") && Catch::Contains("axial_strain"));
  CHECK_THAT(refusal(ExperimentType::uniaxial, "axial_strain,axial_stress_mpa\n"), Catch::Contains("no rows"));
  CHECK_THAT(refusal(ExperimentType::uniaxial, "axial_strain,axial_stress_mpa\n0,1\n0.1,x\n"),
             Catch::Contains("lab.csv:3") && Catch::Contains("axial_stress_mpa"));
}

TEST_CASE("Without a measured file there are no curves") { CHECK(read_measured_curves(RunConfig()).empty()); }

TEST_CASE("A measured file's path counts from the configuration's folder, and changes no hash") {
  const auto folder = fresh_folder("measured_path");
  const std::string origin = (folder / "run.json").string();
  CHECK_THAT(parse_refusal(kJointRun, origin),
             Catch::Contains("/output/measured_curve: no such file") && Catch::Contains((folder / "lab.csv").string()));
  std::ofstream(folder / "lab.csv") << "shear_displacement_mm,shear_stress_mpa\n0,0\n";
  const RunConfig config = parse_run_config(kJointRun, origin);
  CHECK(config.output.measured_curve == (folder / "lab.csv").string());
  CHECK(config.output.measured_name == "lab");
  RunConfig bare = config;
  bare.output.measured_curve.reset();
  bare.output.measured_name.reset();
  CHECK(config_hash(bare) == config_hash(config));
  CHECK_THAT(parse_refusal(R"({"experiment": {"type": "brazilian"}, "output": {"measured_name": "lab"}})", origin),
             Catch::Contains("/output/measured_name") && Catch::Contains("not given"));
}
