#include "core/calibration/assembly_elasticity.hpp"

#include <catch2/catch.hpp>

#include "core/base/error.hpp"
#include "core/calibration/contact_stiffness.hpp"
#include "core/experiment/run.hpp"
#include "core/measurement/results.hpp"
#include "tests/unit/calibration/plaster.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

/// A test up to just beyond its window, stepped in time.
ElasticResult stepped(RunConfig config, double strength) {
  config.experiment.loading.closing_rate_mm_per_s = 60;
  config.experiment.stop.axial_strain = 0.6 * strength / 1300 / 0.9;
  const ParallelLoops loops;
  Model model = build_model(config, loops);
  RunState state = start_run(model);
  run_experiment(model, state, loops, {});
  const Peak failure{state.samples.size(), strength};
  return fit_moduli(state.samples, failure, config).value();
}

}  // namespace

TEST_CASE("the window's static reading is that of a test stepped in time") {
  for (PlaneCondition plane : {PlaneCondition::stress, PlaneCondition::strain}) {
    const RunConfig config = with_elasticity(coarse_plaster(plane), {2000, 0.1}, {2200, 0.3});
    const AssemblyElasticity read = read_assembly(config, ElasticReading::window, 7.5);
    CHECK(read.window_reached);
    CHECK(read.window.low == Approx(1.5));
    CHECK(read.window.high == Approx(3.75));
    const ElasticResult run = stepped(config, 7.5);
    CHECK(read.youngs_modulus_gpa == Approx(run.youngs_modulus_gpa).epsilon(0.0015));  // inertia
    CHECK(read.poissons_ratio == Approx(run.poissons_ratio).epsilon(0.003));
  }
}

TEST_CASE("the window's reading tends to the initial one as the contacts get strong") {
  RunConfig config = with_elasticity(coarse_plaster(PlaneCondition::strain), {2000, 0.1}, {2200, 0.3});
  const AssemblyElasticity initial = read_assembly(config, ElasticReading::initial, 7.5);
  const double weak = read_assembly(config, ElasticReading::window, 7.5).youngs_modulus_gpa;
  config.contacts.cohesion_mpa = config.contacts.tensile_strength_mpa = 1e3;
  config.contacts.fracture_energy_n_per_mm = 1e5;
  const AssemblyElasticity strong = read_assembly(config, ElasticReading::window, 7.5);
  // What is left are the strains themselves: the window's mid strain is 0.2 %, and the specimen's cross section grows.
  CHECK(strong.youngs_modulus_gpa == Approx(initial.youngs_modulus_gpa).epsilon(0.005));
  CHECK(strong.poissons_ratio == Approx(initial.poissons_ratio).epsilon(0.01));
  CHECK(weak < 0.95 * initial.youngs_modulus_gpa);
}

TEST_CASE("where contacts soften below the window it is cut, and that is told") {
  RunConfig config = with_elasticity(coarse_plaster(PlaneCondition::strain), {2000, 0.1}, {2200, 0.3});
  config.contacts.cohesion_mpa = 0.6;
  const AssemblyElasticity read = read_assembly(config, ElasticReading::window, 7.5);
  CHECK_FALSE(read.window_reached);
  CHECK(read.window.high < 3.75);
  CHECK(read.window.low <= 0.5 * read.window.high);
  CHECK(read.separation == Approx(0.99).epsilon(0.011));  // Eq. (E6), within the elastic start's own margin
  CHECK(read.youngs_modulus_gpa > 0.5);
}

TEST_CASE("platen friction and the integration's settings do not enter the reading") {
  RunConfig config = with_elasticity(coarse_plaster(PlaneCondition::strain), {2000, 0.1}, {2200, 0.3});
  const double plain = read_assembly(config, ElasticReading::initial, 7.5).youngs_modulus_gpa;
  config.experiment.platens.friction_coefficient = 0.3;
  config.integration.time_step_s = 1.0;  // far above the stable one
  CHECK(read_assembly(config, ElasticReading::initial, 7.5).youngs_modulus_gpa == plain);
}

TEST_CASE("only a uniaxial test is read") {
  RunConfig config = coarse_plaster(PlaneCondition::stress);
  config.experiment.type = ExperimentType::brazilian;
  CHECK_THROWS_AS(read_assembly(config, ElasticReading::initial, 7.5), Error);
}
