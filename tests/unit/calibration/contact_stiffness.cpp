#include "core/calibration/contact_stiffness.hpp"

#include <catch2/catch.hpp>

#include "tests/unit/calibration/plaster.hpp"

using namespace asperity;
using namespace asperity::testing;

TEST_CASE("the closed form's stiffness is the paper's Eqs 12 and 13 with the corrected Eq 14") {
  const MaterialConfig plaster;  // the paper's Table 2
  const ContactStiffness strain = stiffness_by_rule({StiffnessRule::closed_form}, plaster, 2.0, PlaneCondition::strain);
  CHECK(strain.k_t == Approx(2608).epsilon(1e-3));
  CHECK(strain.k_s() == Approx(727).epsilon(1e-3));
  const ContactStiffness stress = stiffness_by_rule({StiffnessRule::closed_form}, plaster, 1.0, PlaneCondition::stress);
  CHECK(stress.k_t == Approx(2504).epsilon(1e-3));
  CHECK(stress.k_s() == Approx(698).epsilon(1e-3));
}

TEST_CASE("a multiple of E over the edge is the same in both planes") {
  for (PlaneCondition plane : {PlaneCondition::stress, PlaneCondition::strain}) {
    const ContactStiffness k = stiffness_by_rule({StiffnessRule::multiple, 10.0}, {}, 2.0, plane);
    CHECK(k.k_t == Approx(6500));
    CHECK(k.ratio == Approx(0.279).epsilon(1e-3));
  }
}

TEST_CASE("stiffness times edge is kept, and with it the assembly's elasticity") {
  CHECK(stiffness_at_edge(2600, 2.0, 0.5) == Approx(10400));
  const Elasticity particle{2000, 0.15};
  const Elasticity coarse = estimate_assembly(particle, {2600, 0.3}, 2.0, PlaneCondition::strain);
  const Elasticity fine =
      estimate_assembly(particle, {stiffness_at_edge(2600, 2.0, 0.2), 0.3}, 0.2, PlaneCondition::strain);
  CHECK(fine.youngs_modulus == Approx(coarse.youngs_modulus));
  CHECK(fine.poissons_ratio == Approx(coarse.poissons_ratio));
}

TEST_CASE("a configuration takes particles and contacts over") {
  const RunConfig config = with_elasticity(coarse_plaster(PlaneCondition::strain), {2000, 0.15}, {2600, 0.3});
  CHECK(config.particles.youngs_modulus_gpa == Approx(2.0));
  CHECK(config.particles.poissons_ratio == 0.15);
  CHECK(config.contacts.tensile_stiffness_mpa_per_mm == Approx(2600));
  CHECK(config.contacts.shear_stiffness_mpa_per_mm == Approx(780));
}
