#include "core/confrontation/virtual_test.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/config/read_config.hpp"
#include "core/config/write_config.hpp"
#include "core/confrontation/confrontation_task.hpp"
#include "tests/unit/confrontation/confrontation_folder.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

RunConfig test_of(const ConfrontationConfig& config, const std::string& id) {
  return virtual_test(config, *find_test(config.measured, id));
}

}  // namespace

TEST_CASE("a virtual test has the measured sizes and pressures, and the base's loading") {
  const ConfrontationFolder folder("virtual");
  json document = confrontation();
  document["bases"]["uniaxial"]["experiment"]["loading"] = {{"closing_rate_mm_per_s", 170}};
  const ConfrontationConfig config = folder.read(document);
  const RunConfig u = test_of(config, "U"), t = test_of(config, "T1"), b = test_of(config, "B"),
                  j = test_of(config, "J");
  CHECK(u.name == "case_U");
  CHECK(u.experiment.width_mm == 50.0);
  CHECK(u.experiment.height_mm == 100.0);
  CHECK(u.measurement.axial_gauge_mm == 60.0);
  CHECK(u.experiment.loading.closing_rate_mm_per_s == 170.0);
  CHECK(t.experiment.type == ExperimentType::triaxial);
  CHECK(t.experiment.confining_pressure_mpa == 1.0);
  CHECK(t.experiment.height_mm == 40.0);
  CHECK(t.measurement.axial_gauge_mm == 25.0);
  CHECK(t.experiment.loading.closing_rate_mm_per_s == 170.0);
  CHECK(b.experiment.diameter_mm == 48.0);
  CHECK(j.experiment.normal_stress_mpa == 1.5);
  REQUIRE(j.joint.profile.size() == 1);
  CHECK(j.joint.profile[0] == ToothConfig{25.0, 4.0, 3.0});
  CHECK(j.joint.end_gap_mm == 2.0);
  CHECK(j.joint.points_mm.empty());
}

TEST_CASE("a uniaxial test on a triaxial base, and a gauge that would not fit") {
  ConfrontationFolder folder("turned");
  json document = confrontation();
  json base = run_base("triaxial", 1600.0);
  base["experiment"]["confining_pressure_mpa"] = 2.0;
  base["experiment"]["loading"] = {{"confinement_time_s", 0.001}};
  document["bases"].erase("uniaxial");
  document["bases"]["triaxial"] = base;
  folder.measured["tests"][1].erase("axial_gauge_mm");
  const ConfrontationConfig config = folder.read(document);
  CHECK(test_of(config, "U").experiment.type == ExperimentType::uniaxial);
  CHECK(test_of(config, "U").experiment.confining_pressure_mpa == 0.0);
  CHECK(test_of(config, "T1").measurement.axial_gauge_mm == 40.0);
}

TEST_CASE("the hash of the data is that of numbers and conditions, the frozen one that of all that is decided") {
  ConfrontationFolder folder("hashes");
  const auto context = [&](const json& document) {
    const ConfrontationConfig config = folder.read(document);
    const auto count = static_cast<Eigen::Index>(config.parameters.size());
    Confrontation c;
    c.centre = c.base.coded = c.base.error = Eigen::VectorXd::Zero(count);
    c.base.determined = c.base.limited = std::vector<bool>(config.parameters.size(), false);
    return verdict_context(config, confrontation_task(config, nullptr), c);
  };
  const VerdictContext first = context(confrontation());
  json other_edge = confrontation();
  other_edge["bases"]["uniaxial"]["particles"]["edge_mm"] = 3.5;
  CHECK(context(other_edge).data_sha256 == first.data_sha256);
  CHECK(context(other_edge).frozen_sha256 != first.frozen_sha256);
  folder.measured["name"] = "X";
  folder.measured["tests"][0]["note"] = "dried";
  CHECK(context(confrontation()).data_sha256 == first.data_sha256);
  CHECK(context(confrontation()).frozen_sha256 == first.frozen_sha256);
  folder.measured["tests"][1]["confining_pressure_mpa"] = 1.5;
  CHECK(context(confrontation()).data_sha256 != first.data_sha256);
}

TEST_CASE("a note tells that nothing was measured on two specimens") {
  const ConfrontationFolder folder("notes");
  const ConfrontationConfig config = folder.read(confrontation());
  Confrontation c;
  c.centre = c.base.coded = c.base.error = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(config.parameters.size()));
  c.base.determined = c.base.limited = std::vector<bool>(config.parameters.size(), false);
  const auto noted = [&](const std::string& part) {
    const std::vector<std::string> notes = verdict_context(config, confrontation_task(config, nullptr), c).notes;
    return std::count_if(notes.begin(), notes.end(),
                         [&](const std::string& note) { return note.find(part) != std::string::npos; });
  };
  c.fitted.specimens = Eigen::VectorXd::Constant(3, 1.0);
  CHECK(noted("no fitted feature was measured on two specimens") == 1);
  c.fitted.specimens(1) = 2.0;
  CHECK(noted("no fitted feature was measured on two specimens") == 0);
}

TEST_CASE("values for all tests lie over sizes, those for one test over all") {
  const ConfrontationFolder folder("laid over");
  json document = confrontation();
  document["set"] = {{"/particles/edge_mm", 3.5}, {"/experiment/thickness_mm", 2}};
  document["tests"] = {{"B", {{"set", {{"/particles/edge_mm", 3}}}}}};
  const ConfrontationConfig config = folder.read(document);
  CHECK(test_of(config, "U").particles.edge_mm == 3.5);
  CHECK(test_of(config, "B").particles.edge_mm == 3.0);
  CHECK(test_of(config, "B").experiment.thickness_mm == 2.0);
}

TEST_CASE("what a run draws makes no other run of a virtual test, unless it is asked for") {
  const ConfrontationFolder folder("output");
  json document = confrontation();
  const std::string hash = config_hash(test_of(folder.read(document), "B"));
  document["bases"]["brazilian"]["output"] = {{"frames", 9}, {"width_px", 500}};
  const ConfrontationConfig config = folder.read(document);
  CHECK(test_of(config, "B").output.frames == 0);
  CHECK(config_hash(test_of(config, "B")) == hash);
  CHECK(virtual_test(config, *find_test(config.measured, "B"), VirtualOutput::as_base).output.frames == 9);
}

TEST_CASE("theta and value are inverse; values have twelve digits") {
  for (const auto transform : {ParameterTransform::log, ParameterTransform::tangent, ParameterTransform::linear}) {
    for (const double value : {0.5, 1.33042993, 37.25}) CHECK(value_of(transform, theta_of(transform, value)) == value);
  }
  CHECK(theta_of(ParameterTransform::tangent, 45.0) == Approx(1.0).epsilon(1e-15));
  CHECK(value_of(ParameterTransform::linear, 1.0 / 3.0) == 0.333333333333);
}

TEST_CASE("a configured run has parameters with what is tied to them, mechanisms and its mesh") {
  const ConfrontationFolder folder("configured");
  const ConfrontationConfig config = folder.read(confrontation());
  const RunConfig base = test_of(config, "J");
  std::vector<double> theta = reference_theta(config.parameters);
  RunConfig same = base;
  same.particles.seed = 7;
  CHECK(configured(base, config.parameters, theta, {}, 7) == same);
  theta[0] = std::log(1.56);
  theta[1] = 0.5;
  theta[2] += std::log(1.5);
  const RunConfig run = configured(base, config.parameters, theta, {{"slip_weakening", 0.6, {}}}, 9);
  CHECK(run.contacts.cohesion_mpa == 1.56);
  CHECK(run.contacts.friction_angle_deg == Approx(26.5650511771).epsilon(1e-12));
  CHECK(run.particles.youngs_modulus_gpa == 5.25);
  CHECK(run.contacts.tensile_stiffness_mpa_per_mm == 7800.0);
  CHECK(run.mechanisms.back().type == "slip_weakening");
  CHECK(run.particles.seed == 9);
  CHECK(config_hash(run) != config_hash(base));
}

TEST_CASE("a setting that is off to its other side is a run that a file can state") {
  const ConfrontationFolder folder("other side");
  const ConfrontationConfig config = folder.read(confrontation());
  const std::vector<double> theta = reference_theta(config.parameters);
  const RunConfig run = configured(test_of(config, "U"), config.parameters, theta, {{"loading_rate", -1.8, {}}}, 1);
  const std::string text = effective_json(run);
  CHECK(run.mechanisms.back() == MechanismConfig{"loading_rate", std::nullopt, {{"rate_factor", 1.9}}});
  CHECK(parse_run_config(text, "written", {}) == run);
  CHECK_THROWS_WITH(configured(test_of(config, "U"), config.parameters, theta, {{"damping", -1.2, {}}}, 1),
                    Catch::Contains("case_U: /mechanisms/0/damping_change"));
}

TEST_CASE("a parameter stays where it does not act; what leads out of range is told with the test") {
  const ConfrontationFolder folder("out of range");
  json document = confrontation();
  document["parameters"][0]["only"] = {"brazilian"};
  const ConfrontationConfig config = folder.read(document);
  std::vector<double> theta = reference_theta(config.parameters);
  theta[0] = std::log(2.0);
  CHECK(configured(test_of(config, "U"), config.parameters, theta, {}, 1).contacts.cohesion_mpa == 1.3);
  CHECK(configured(test_of(config, "B"), config.parameters, theta, {}, 1).contacts.cohesion_mpa == 2.0);
  theta[2] = 20.0;
  CHECK_THROWS_WITH(configured(test_of(config, "U"), config.parameters, theta, {}, 1),
                    Catch::Contains("case_U: /particles/youngs_modulus_gpa"));
  theta[2] = std::log(4.0);
  CHECK_THROWS_WITH(configured(test_of(config, "U"), config.parameters, theta, {{"joint_wear", 0.5, {}}}, 1),
                    Catch::Contains("case_U: /mechanisms/0/type"));
}

TEST_CASE("whether a mechanism can act") {
  const ConfrontationFolder folder("can act");
  const ConfrontationConfig config = folder.read(confrontation());
  CHECK(can_act(test_of(config, "J"), "joint_wear"));
  CHECK_FALSE(can_act(test_of(config, "U"), "joint_wear"));
  CHECK(can_act(test_of(config, "U"), "platen_friction"));
}
