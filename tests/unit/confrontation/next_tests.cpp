#include "core/confrontation/next_tests.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/unit/confrontation/confrontation_folder.hpp"

using namespace asperity;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using nlohmann::json;

namespace {

constexpr const char* kFirst = "crack_closure";
constexpr const char* kSecond = "frame_compliance";
constexpr double kScatter = 0.03;          // of a mesh, either way: of four meshes the variance is 4/3 of its square
constexpr double kTriaxialPressure = 1.0;  // MPa, of the made test
constexpr std::size_t kTriaxial = 1, kJoint = 3;
constexpr double kFirstAmplitude = 0.7, kSecondAmplitude = 0.9;

/// Standard deviation of a difference of means, Eq. (N18): sqrt((1/5 + 1/4) 4/3) of the mesh's scatter.
const double kDeviation = std::sqrt(0.6) * kScatter;

/// The laboratory measures strengths, and on the joint what else is given. A modulus is compared where there is one.
ConfrontationConfig config_in(const std::string& name, const json& of_joint) {
  json document = testing::confrontation();
  document["mechanisms"] = json::array({kFirst, kSecond});
  document["features"]["triaxial"] = json::array({"peak_axial_stress_mpa", "youngs_modulus_gpa"});
  testing::ConfrontationFolder folder(name);
  folder.measured["tests"][3]["results"].update(of_joint);
  return folder.read(document);
}

HypothesisFit kept(Index cause, double amplitude, Index parameters) {
  HypothesisFit fit;
  fit.causes = {cause};
  fit.amplitude = VectorXd::Constant(1, amplitude);
  fit.coded = VectorXd::Zero(parameters);
  fit.covariance = MatrixXd::Zero(parameters + 1, parameters + 1);
  return fit;
}

/// Two causes that the data leave; their strengths differ by `apart` above the pressure that was tested, nowhere else.
struct TwoCauses {
  ConfrontationConfig config;
  double apart = 0, joint_apart = 0;
  std::vector<CampaignRun> asked;
  ConfrontationTask task;
  Confrontation c;

  TwoCauses(const std::string& folder, double logarithm_apart, const json& of_joint = json::object())
      : config(config_in(folder, of_joint)), apart(logarithm_apart) {
    task = confrontation_task(config, [this](const std::string&, const std::vector<CampaignRun>& runs) {
      std::vector<RunFeatureValues> all;
      for (const CampaignRun& run : runs) all.push_back(features(run.config));
      asked.insert(asked.end(), runs.begin(), runs.end());
      return all;
    });
    const auto parameters = static_cast<Index>(task.evidence.parameters.size());
    c.evidence = task.evidence;
    c.centre = VectorXd::Zero(parameters);
    c.fitted.jacobian = MatrixXd::Zero(0, parameters);
    c.conclusion.status = VerdictStatus::indistinguishable;
    c.conclusion.kept = {kept(0, kFirstAmplitude, parameters), kept(1, kSecondAmplitude, parameters)};
  }
  TwoCauses(const TwoCauses&) = delete;

  /// All features alike.
  RunFeatureValues features(const RunConfig& run) const {
    double logarithm = run.particles.seed % 2 == 0 ? kScatter : -kScatter;
    const bool pressed = run.experiment.confining_pressure_mpa > 1.5 * kTriaxialPressure;
    const bool first = !run.mechanisms.empty() && run.mechanisms.back().type == kFirst;
    if (pressed && first) logarithm += apart;
    if (run.experiment.type == ExperimentType::direct_shear && first) logarithm += joint_apart;
    return RunFeatureValues(feature_kinds(run.experiment.type).size(), std::exp(logarithm));
  }

  std::vector<NextTest> tests() { return next_tests(config, task, c); }

  double distance_of(const std::string& id) {
    const std::vector<NextTest> all = tests();
    return std::find_if(all.begin(), all.end(), [&](const NextTest& t) { return t.id == id; })->distance;
  }

  bool proposes(const std::string& id) {
    const std::vector<NextTest> all = tests();
    return std::any_of(all.begin(), all.end(), [&](const NextTest& t) { return t.id == id; });
  }
};

}  // namespace

TEST_CASE("the further test that parts two causes best comes first, with the share of right decisions by it") {
  // The modulus, which the laboratory did not measure, would differ, too: it must not count.
  TwoCauses causes("next_tests", 2.0 * kDeviation);
  const std::vector<NextTest> tests = causes.tests();
  REQUIRE(tests.size() >= 2);
  CHECK(tests.front().id == "twice_confining_pressure");
  CHECK(tests.front().separates == std::vector<std::string>{kFirst, kSecond});
  CHECK(tests.front().distance == Approx(2.0));
  CHECK(tests.front().probability_correct == Approx(0.8413447461));  // Phi(1)
  for (std::size_t i = 1; i < tests.size(); ++i) {
    CAPTURE(tests[i].id);
    CHECK(tests[i].id != tests.front().id);
    CHECK(tests[i].distance == 0.0);
    CHECK(tests[i].probability_correct == 0.5);
  }
}

TEST_CASE("gauges of a joint's dilation are proposed where it had none") {
  const json gauges{{"dilation_difference_at_peak_mm", json::array({0.1})}};
  CHECK(TwoCauses("next_tests_no_gauges", 0.0).proposes("dilation_gauges"));
  CHECK(!TwoCauses("next_tests_gauges", 0.0, gauges).proposes("dilation_gauges"));
}

TEST_CASE("what the further test alone gives is known no better than what is read like it") {
  TwoCauses causes("next_tests_like", 0.0);
  causes.joint_apart = 2.0 * kDeviation;
  CHECK(causes.distance_of("dilation_gauges") == Approx(2.0 * std::sqrt(2.0)).epsilon(0.05));  // with the shear stress
  const TestEvidence& joint = causes.c.evidence.tests[kJoint];
  Index slot = 0;
  while (joint.slots[static_cast<std::size_t>(slot)].kind->name != "peak_dilation_mm") ++slot;
  causes.c.fitted.tests.push_back({&joint, {slot}, 0, {}, 0});
  causes.c.fitted.jacobian = MatrixXd::Zero(1, causes.c.fitted.jacobian.cols());
  causes.c.scatter.covariance = MatrixXd::Constant(1, 1, 100.0);
  CHECK(causes.distance_of("dilation_gauges") == Approx(2.0).epsilon(0.05));
}

TEST_CASE("each cause is run with its own amplitude and parameters on the same four meshes") {
  TwoCauses causes("next_tests_runs", kDeviation);
  causes.c.conclusion.kept[0].coded(0) = 2.0;  // c_c: 0.08 a step, 1.3 MPa at the reference
  causes.tests();
  std::vector<std::uint64_t> seeds[2];
  for (const CampaignRun& run : causes.asked) {
    if (run.config.experiment.confining_pressure_mpa != 2.0 * kTriaxialPressure) continue;
    REQUIRE(run.config.mechanisms.size() == 1);
    const bool first = run.config.mechanisms[0].type == kFirst;
    CHECK(run.config.mechanisms[0].amplitude == (first ? kFirstAmplitude : kSecondAmplitude));
    CHECK(run.config.contacts.cohesion_mpa == Approx(first ? 1.3 * std::exp(0.16) : 1.3));
    seeds[first ? 0 : 1].push_back(run.config.particles.seed);
  }
  const std::uint64_t fresh = causes.task.plan.fresh_seed;
  CHECK(seeds[0] == std::vector<std::uint64_t>{fresh, fresh + 1, fresh + 2, fresh + 3});
  CHECK(seeds[1] == seeds[0]);
}

TEST_CASE("what is not known of parameters that move the test lowers the distance") {
  TwoCauses causes("next_tests_parameters", 2.0 * kDeviation);
  const double slope = 0.03;  // of the logarithm, a step of the first parameter; the others do not move the test
  causes.c.fitted.tests.push_back({&causes.c.evidence.tests[kTriaxial], {0}, 0, {}, 0});
  causes.c.fitted.jacobian = MatrixXd::Zero(1, causes.c.fitted.jacobian.cols());
  causes.c.fitted.jacobian(0, 0) = slope;
  // What is fitted is known as well as it was measured: here as five specimens of that variance.
  causes.c.scatter.covariance = MatrixXd::Constant(1, 1, 4.0 / 3.0 * kScatter * kScatter / 5.0);
  // Together they add three times kDeviation^2, so that the deviation doubles: D is 1 in place of 2.
  const double together = 3.0 * kDeviation * kDeviation / (slope * slope);
  causes.c.conclusion.kept[0].covariance(0, 0) = 0.6 * together;
  causes.c.conclusion.kept[1].covariance(0, 0) = 0.4 * together;
  causes.c.conclusion.kept[0].covariance(1, 1) = 5.0;
  const std::vector<NextTest> tests = causes.tests();
  REQUIRE(!tests.empty());
  CHECK(tests.front().id == "twice_confining_pressure");
  CHECK(tests.front().distance == Approx(1.0));
  CHECK(tests.front().probability_correct == Approx(0.6914624613));  // Phi(1/2)
}

TEST_CASE("of doubles only the test that is made for them counts") {
  TwoCauses causes("next_tests_doubles", 2.0 * kDeviation);
  causes.c.evidence.candidates[0].doubles = {kSecond};
  causes.c.evidence.candidates[1].doubles = {kFirst};
  CHECK(causes.tests().empty());
  // What the candidates are called decides which test that is; the mechanisms that are run do not matter here.
  causes.c.evidence.candidates[0] = {.id = "strength_scatter", .doubles = {"initial_defects"}};
  causes.c.evidence.candidates[1] = {.id = "initial_defects", .doubles = {"strength_scatter"}};
  const std::vector<NextTest> tests = causes.tests();
  REQUIRE(tests.size() == 1);
  CHECK(tests.front().id == "half_size");
}

TEST_CASE("no further test is sought where the data do not leave several single causes") {
  TwoCauses causes("next_tests_none", 2.0 * kDeviation);
  for (const VerdictStatus status :
       {VerdictStatus::nothing_found, VerdictStatus::named, VerdictStatus::two_causes, VerdictStatus::unexplained}) {
    causes.c.conclusion.status = status;
    CHECK(causes.tests().empty());
  }
  CHECK(causes.asked.empty());
}
