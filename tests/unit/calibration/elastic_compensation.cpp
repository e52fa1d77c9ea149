#include "core/calibration/elastic_compensation.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/error.hpp"
#include "core/calibration/elastic_alternatives.hpp"
#include "core/calibration/elastic_json.hpp"
#include "core/calibration/elastic_search.hpp"
#include "tests/unit/calibration/plaster.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

constexpr double kTolerance = 0.005;  // what the issue asks of E and nu

void check_target(const ElasticTask& task, const Elasticity& assembly) {
  CHECK(assembly.youngs_modulus == Approx(1e3 * task.target.youngs_modulus_gpa).epsilon(kTolerance));
  CHECK(assembly.poissons_ratio == Approx(task.target.poissons_ratio).epsilon(kTolerance));
}

/// A specimen that is the closed form itself, for the search alone.
struct ClosedForm {
  double edge_mm;
  PlaneCondition plane;
  Elasticity operator()(const ElasticTrial& trial) const {
    return estimate_assembly(trial.particle, trial.contacts, edge_mm, plane);
  }
};

}  // namespace

TEST_CASE(
    "compensated assemblies show the target in the mean of their seeds, with free particles or a floating ratio") {
  const std::vector<std::pair<PlaneCondition, double>> cases{{PlaneCondition::strain, 4.0},
                                                             {PlaneCondition::stress, 10.0}};
  for (const auto& [plane, multiple] : cases) {
    ElasticTask task = coarse_task(plane);
    task.stiffness = {StiffnessRule::multiple, multiple};
    const ElasticCompensation found = compensate_elasticity(task);
    CAPTURE(multiple, static_cast<int>(plane), found.steps.size());
    REQUIRE(found.reached);
    check_target(task, found.answer().assembly);
    // Hardening is in the guess: without it E would begin 10 % low.
    CHECK(found.steps.front().assembly.youngs_modulus == Approx(1300).epsilon(0.02));
    CHECK(found.steps.size() <= 4);  // two here: the closed form's guess and one correction
    CHECK(found.unknowns == (multiple == 4.0 ? ElasticUnknowns::ratio : ElasticUnknowns::particle));
    CHECK(found.answer().particle.poissons_ratio >= task.bounds.least_poissons_ratio);
    check_target(task, mean_elasticity(read_specimens(task, found.answer().particle, found.answer().contacts)));
  }
}

TEST_CASE("with Eqs 12, 13 no admissible nu_p reaches the plaster's nu, so the ratio floats") {
  ElasticTask task = coarse_task(PlaneCondition::strain);
  task.stiffness = {StiffnessRule::multiple, 4.0};  // Eq 13 at the paper's 2 mm
  task.ratio = RatioPolicy::fixed;
  const ElasticCompensation fixed = compensate_elasticity(task);
  CHECK(fixed.unknowns == ElasticUnknowns::modulus);
  CHECK_FALSE(fixed.reached);
  CHECK(fixed.answer().particle.poissons_ratio == task.bounds.least_poissons_ratio);
  CHECK(fixed.answer().assembly.youngs_modulus == Approx(1300).epsilon(kTolerance));
  CHECK(fixed.answer().assembly.poissons_ratio > 0.21);
  task.ratio = RatioPolicy::floats;
  const ElasticCompensation floating = compensate_elasticity(task);
  CHECK(floating.reached);
  CHECK(floating.answer().contacts.ratio > fixed.answer().contacts.ratio);
}

TEST_CASE("contacts softer than Eq. (K34) allows make the search end at the greatest E_p and say so") {
  ElasticTask task = coarse_task(PlaneCondition::strain);
  const double least = least_stiffness({1300, 0.2}, task.config.particles.edge_mm, PlaneCondition::strain);
  task.stiffness = {StiffnessRule::multiple, 0.8 * least * task.config.particles.edge_mm / 1300};
  const ElasticCompensation found = compensate_elasticity(task);
  CHECK_FALSE(found.reached);
  CHECK(found.steps.size() == 1);
  CHECK(found.answer().particle.youngs_modulus == Approx(20 * 1300));
  CHECK(found.answer().assembly.youngs_modulus < 1300);
}

TEST_CASE("the initial reading is compensated too, and its answer depends on no strength") {
  ElasticTask task = coarse_task(PlaneCondition::strain);
  task.reading = ElasticReading::initial;
  task.stiffness = {StiffnessRule::multiple, 10.0};
  const ElasticCompensation found = compensate_elasticity(task);
  REQUIRE(found.reached);
  check_target(task, found.answer().assembly);
  task.config.contacts.cohesion_mpa = 0.5;
  CHECK(compensate_elasticity(task).answer().particle.youngs_modulus == found.answer().particle.youngs_modulus);
}

TEST_CASE("no figure depends on the number of threads") {
  ElasticTask task = coarse_task(PlaneCondition::strain);
  task.seeds = {1, 2, 3, 4};
  const std::string one = elastic_json(task, compensate_elasticity(task), {}).dump();
  task.threads = 3;
  CHECK(elastic_json(task, compensate_elasticity(task), {}).dump() == one);
}

TEST_CASE("every seed is a specimen of its own, read as a run with that seed would be") {
  ElasticTask task = coarse_task(PlaneCondition::strain);
  task.reading = ElasticReading::initial;
  task.seeds = {7, 3};
  const auto specimens = read_specimens(task, {2000, 0.1}, {2200, 0.3});
  REQUIRE(specimens.size() == 2);
  CHECK(specimens[0].youngs_modulus_gpa != specimens[1].youngs_modulus_gpa);
  RunConfig config = with_elasticity(task.config, {2000, 0.1}, {2200, 0.3});
  config.particles.seed = 3;
  CHECK(specimens[1].youngs_modulus_gpa == read_assembly(config, ElasticReading::initial, 7.5).youngs_modulus_gpa);
}

TEST_CASE("where the closed form is exact the search needs one trial with either set of unknowns") {
  for (PlaneCondition plane : {PlaneCondition::stress, PlaneCondition::strain}) {
    for (double multiple : {3.5, 10.0}) {
      ElasticTask task = coarse_task(plane);
      task.reading = ElasticReading::initial;
      task.stiffness = {StiffnessRule::multiple, multiple};
      const ElasticSearch search(task);
      const ClosedForm specimen{task.config.particles.edge_mm, plane};
      CHECK(elastic_misfit(specimen(search.trial()), task.target) < 1e-12);
    }
  }
}

TEST_CASE("the search finds a specimen that is a third stiffer and wider than the closed form says") {
  for (double multiple : {3.5, 10.0}) {
    ElasticTask task = coarse_task(PlaneCondition::strain);
    task.reading = ElasticReading::initial;
    task.stiffness = {StiffnessRule::multiple, multiple};
    ElasticSearch search(task);
    const ClosedForm specimen{task.config.particles.edge_mm, PlaneCondition::strain};
    double misfit = 1.0;
    for (int i = 0; i < 10 && misfit > 1e-9; ++i) {
      Elasticity assembly = specimen(search.trial());
      assembly.youngs_modulus *= 1.33;
      assembly.poissons_ratio *= 1.1;
      misfit = elastic_misfit(assembly, task.target);
      search.advance(assembly);
    }
    CHECK(misfit < 1e-9);
  }
}

TEST_CASE("scatter and misfit by hand") {
  std::vector<AssemblyElasticity> specimens(2);
  specimens[0].youngs_modulus_gpa = 1.2;
  specimens[1].youngs_modulus_gpa = 1.4;
  specimens[0].poissons_ratio = 0.19;
  specimens[1].poissons_ratio = 0.21;
  CHECK(mean_elasticity(specimens).youngs_modulus == Approx(1300));
  CHECK(elasticity_scatter(specimens).youngs_modulus == Approx(std::sqrt(2.0) * 100));
  CHECK(elasticity_scatter(specimens).poissons_ratio == Approx(std::sqrt(2.0) * 0.01));
  CHECK(elasticity_scatter({specimens[0]}).youngs_modulus == 0.0);
  CHECK(elastic_misfit({1313, 0.2}, {1.3, 0.2}) == Approx(0.01));
  CHECK(elastic_misfit({1300, 0.196}, {1.3, 0.2}) == Approx(0.02));
  CHECK(elastic_misfit({1300, 0.001}, {1.3, 0.0}) == Approx(0.01));
}

TEST_CASE("a task without meaning is refused with every fault") {
  ElasticTask task = coarse_task(PlaneCondition::strain);
  task.target = {-1, 0.6, 0};
  task.seeds.clear();
  task.bounds.least_poissons_ratio = 0.4;
  try {
    compensate_elasticity(task);
    FAIL("accepted");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::config);
    CHECK(error.faults().size() == 5);
  }
  task = coarse_task(PlaneCondition::strain);
  task.config.experiment.type = ExperimentType::brazilian;
  CHECK_THROWS_AS(compensate_elasticity(task), Error);
}

TEST_CASE("the JSON object has the contract's keys, both planes' stiffness and the alternatives") {
  ElasticTask task = coarse_task(PlaneCondition::strain);
  task.stiffness = {StiffnessRule::closed_form};
  task.config.particles.edge_mm = 8;
  task.seeds = {1};
  const ElasticCompensation found = compensate_elasticity(task);
  const auto j = elastic_json(task, found, elastic_alternatives(task));
  for (const char* key : {"rule", "particle_youngs_modulus_gpa", "particle_poissons_ratio", "stiffness_ratio",
                          "assembly", "steps", "alternatives"}) {
    CHECK(j.contains(key));
  }
  CHECK(j["rule"] == "closed_form");
  CHECK(j["tensile_stiffness_mpa_per_mm"]["stress"].get<double>() == Approx(2504).epsilon(1e-3));  // the paper's Eq 12
  CHECK(j["tensile_stiffness_mpa_per_mm"]["strain"].get<double>() == Approx(2608).epsilon(1e-3));  // and 13
  CHECK(j["steps"].size() == found.steps.size());
  REQUIRE(j["alternatives"].size() == 5);
  const auto& own = j["alternatives"][0];
  CHECK(own["particle_youngs_modulus_gpa"] == 1.3);
  CHECK(own["youngs_modulus_gpa"].get<double>() < 1.2);
  CHECK_FALSE(own["reached"].get<bool>());
  CHECK(j["alternatives"][2]["edge_mm"] == 4.0);
}
