#include "core/confrontation/preparation.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "core/confrontation/confrontation_task.hpp"
#include "core/confrontation/next_tests.hpp"
#include "core/confrontation/virtual_test.hpp"
#include "tests/unit/confrontation/confrontation_folder.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

constexpr std::size_t kUniaxial = 0, kTurned = 1, kLubricated = 2;

/// The laboratory's uniaxial test, cores drilled at a right angle to its, and others between lubricated platens.
ConfrontationConfig prepared(const std::string& name, const json& mechanisms_of_the_base = json::array()) {
  ConfrontationFolder folder(name);
  json tests = json::array({folder.measured["tests"][0]});
  tests.push_back(tests[0]);
  tests.push_back(tests[0]);
  tests[kTurned].update({{"id", "R"}, {"core_angle_deg", 90}});
  tests[kLubricated].update({{"id", "L"}, {"lubricated_platens", true}});
  folder.measured["tests"] = tests;
  json document = confrontation();
  document["mechanisms"] = {"platen_friction", "weak_plane"};
  document["bases"]["uniaxial"]["mechanisms"] = mechanisms_of_the_base;
  return folder.read(document);
}

std::vector<MechanismConfig> run_with(const ConfrontationTask& task, std::size_t test, const std::string& mechanism) {
  const auto parameters = static_cast<Eigen::Index>(task.evidence.parameters.size());
  return task.configure({test, Eigen::VectorXd::Zero(parameters), {{mechanism, 0.6}}, 1})->mechanisms;
}

double angle_of(const MechanismConfig& m) { return m.parameters.at("angle_deg"); }

}  // namespace

TEST_CASE("a weak plane turns with the core, and a half turn is none") {
  const MechanismConfig declared{"weak_plane", 0.6, {}}, own{"weak_plane", 0.6, {{"angle_deg", -20.0}}};
  CHECK(angle_of(*acting_in({90.0, false}, declared)) == -30.0);  // declared at 60
  CHECK(angle_of(*acting_in({-90.0, false}, declared)) == -30.0);
  CHECK(angle_of(*acting_in({25.0, false}, declared)) == 35.0);
  CHECK(angle_of(*acting_in({90.0, false}, own)) == 70.0);
  CHECK(*acting_in({}, declared) == declared);
  CHECK(*acting_in({90.0, true}, {"weak_plane", 0.0, {}}) == MechanismConfig{"weak_plane", 0.0, {}});
  CHECK(*acting_in({90.0, true}, {"seating", 1.0, {}}) == MechanismConfig{"seating", 1.0, {}});
  CHECK(!acting_in({0.0, true}, {"platen_friction", 1.0, {}}));
  CHECK(both({90.0, false}, {90.0, true}) == Preparation{0.0, true});
}

TEST_CASE("candidates act as the specimens of a test were prepared") {
  const ConfrontationTask task = confrontation_task(prepared("prepared"), {});
  CHECK(run_with(task, kUniaxial, "weak_plane").at(0).parameters.empty());
  CHECK(angle_of(run_with(task, kTurned, "weak_plane").at(0)) == -30.0);
  CHECK(run_with(task, kLubricated, "weak_plane").at(0).parameters.empty());
  CHECK(task.evidence.candidates[0].id == "platen_friction");
  CHECK(task.plan.candidate_acts[kUniaxial] == std::vector<bool>{true, true});
  CHECK(task.plan.candidate_acts[kTurned] == std::vector<bool>{true, true});
  CHECK(task.plan.candidate_acts[kLubricated] == std::vector<bool>{false, true});
  CHECK(run_with(task, kTurned, "platen_friction").size() == 1);
  CHECK(run_with(task, kLubricated, "platen_friction").empty());
}

TEST_CASE("so do mechanisms of the base") {
  const ConfrontationConfig config = prepared("prepared_base", {{{"type", "damping"}}});
  ConfrontationConfig soft = config;
  soft.bases.at(ExperimentType::uniaxial).document["mechanisms"] = {{{"type", "platen_friction"}},
                                                                    {{"type", "weak_plane"}, {"angle_deg", 10}}};
  const auto of = [&](std::size_t test) { return virtual_test(soft, soft.measured.tests[test]).mechanisms; };
  REQUIRE(of(kUniaxial).size() == 2);
  CHECK(angle_of(of(kUniaxial)[1]) == 10.0);
  CHECK(angle_of(of(kTurned)[1]) == -80.0);
  REQUIRE(of(kLubricated).size() == 1);
  CHECK(of(kLubricated)[0].type == "weak_plane");
}

TEST_CASE("preparations belong to some experiments alone") {
  ConfrontationFolder folder("unprepared");
  folder.measured["tests"][2]["lubricated_platens"] = true;
  folder.measured["tests"][3]["core_angle_deg"] = 90;
  const std::vector<Fault> faults = folder.faults(confrontation());
  REQUIRE(faults.size() == 2);
  CHECK(faults[0].where.ends_with("/tests/2/lubricated_platens"));
  CHECK(faults[1].where.ends_with("/tests/3/core_angle_deg"));
}
