#include "core/experiment/model.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/error.hpp"
#include "tests/unit/experiment/small_models.hpp"

using namespace asperity;
using namespace asperity::testing;

TEST_CASE("the time step is the safety factor times the critical one") {
  RunConfig config = small_config(ExperimentType::brazilian);
  config.integration.safety_factor = 0.5;
  const Model model = small_model(config);
  CHECK(model.critical_time_step > 0.0);
  CHECK(model.system.time_step == 0.5 * model.critical_time_step);
  CHECK(model.added_mass_fraction == 0.0);
}

TEST_CASE("a given time step is taken up to the critical one and refused above it, with both figures") {
  RunConfig config = small_config(ExperimentType::brazilian);
  const double critical = small_model(config).critical_time_step;
  config.integration.time_step_s = 0.999 * critical;
  CHECK(small_model(config).system.time_step == 0.999 * critical);
  config.integration.time_step_s = 1.001 * critical;
  try {
    small_model(config);
    FAIL("accepted");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::config);
    REQUIRE(error.faults().size() == 1);
    const Fault& fault = error.faults()[0];
    CHECK(fault.where == "/integration/time_step_s");
    CHECK(fault.value == std::to_string(1.001 * critical * 1e9) + " ns");
    CHECK(fault.allowed == "at most " + std::to_string(critical * 1e9) + " ns");
    CHECK_FALSE(fault.hint.empty());
  }
}

TEST_CASE("mass scaling reaches the time step asked for and says how much mass it took") {
  RunConfig config = small_config(ExperimentType::brazilian);
  const double step = 1.5 * small_model(config).system.time_step;
  config.integration.mass_scaling_time_step_s = step;
  const Model model = small_model(config);
  CHECK(model.added_mass_fraction > 0.0);
  CHECK(model.system.time_step == step);
  CHECK(model.critical_time_step > step);
}

TEST_CASE("uniform mass scaling lengthens the time step by its factor") {
  RunConfig config = small_config(ExperimentType::uniaxial);
  const double step = small_model(config).system.time_step;
  config.integration.mass_scaling.uniform = true;
  config.integration.mass_scaling.time_step_factor = 1.3;
  const Model model = small_model(config);
  CHECK(model.system.time_step == Approx(1.3 * step).epsilon(2e-3));
  CHECK(model.added_mass_fraction > 0.0);
}

TEST_CASE("platens touch the specimen's ends, with the contacts' stiffness spread over the ends' length") {
  const Model model = small_model(small_config(ExperimentType::uniaxial));
  const System& system = model.system;
  CHECK(system.platens.present);
  CHECK(system.platens.y == std::array<double, 2>{0.0, 65.0});
  double bottom = 0.0, top = 0.0;
  for (std::size_t i = 0; i < system.particles.node_count(); ++i) {
    const PlatenSpring spring = system.platen_springs.at(i);
    const double y = system.particles.reference(i).y;
    CHECK(spring.stiffness > 0.0);
    if (spring.skin == 0.0) (y < 32.5 ? bottom : top) += spring.stiffness;
  }
  CHECK(bottom == Approx(27 * system.contacts.law.k_t).epsilon(1e-14));  // a sum of ten halves: rounding only
  CHECK(top == Approx(27 * system.contacts.law.k_t).epsilon(1e-14));
}

TEST_CASE("a disc has neither flanks nor gauges") {
  const Model model = small_model(small_config(ExperimentType::brazilian));
  CHECK(model.system.flank.edges.empty());
  CHECK(model.gauges.axial_base_mm == 0.0);
  CHECK(specimen_length(model.config) == 54.0);
}

TEST_CASE("the flanks are both sides in full, each edge with the specimen on its left") {
  const Model model = small_model(small_config(ExperimentType::uniaxial));
  double left = 0.0, right = 0.0;
  for (const LoadedEdge& edge : model.system.flank.edges) {
    const Vec2 p = model.system.particles.reference(edge.nodes[0]);
    const Vec2 q = model.system.particles.reference(edge.nodes[1]);
    CHECK(edge.share == 1.0);
    CHECK(p.x == q.x);
    CHECK(std::abs(p.x) == 13.5);
    (p.x < 0 ? left : right) += q.y - p.y;
  }
  CHECK(left == Approx(-65.0).epsilon(1e-14));  // sums of some 13 lengths: rounding only
  CHECK(right == Approx(65.0).epsilon(1e-14));
}

TEST_CASE("large meshes get all cores and small ones a single thread") {
  CHECK(default_threads(19999) == 1);
  CHECK(default_threads(20000) >= 1);
}
