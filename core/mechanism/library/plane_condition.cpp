#include "core/contact/closed_forms.hpp"
#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

using enum ExperimentType;

/// Eq. (X24). Suspect: a plane model of a body that is not plane.
const Registered kEntry{{
    .declaration = {.id = "plane_condition",
                    .title = "the other plane condition",
                    .equation = "(X24) plane stress for plane strain, and the other way round; contact stiffness stays",
                    .source = "Timoshenko & Goodier; the audit (a cylinder is neither)",
                    .reason = "the other limit of the two",
                    .expectation = "modulus and lateral strain change",
                    .acts_in = {uniaxial, triaxial, brazilian, direct_shear},
                    .parameters = {{.key = "other",
                                    .unit = "1",
                                    .description = "1: the other condition, 0: the file's",
                                    .lowest = 0.0,
                                    .highest = 1.0,
                                    .strong = 1.0,
                                    .neutral = 0.0,
                                    .whole = true}},
                    .suspect = true,
                    .allows_elastic_start = true},
    .set =
        [](const MechanismValues& value, RunConfig& config) {
          if (value("other") == 0.0) return;
          PlaneCondition& plane = config.experiment.plane;
          const DerivedParameters before = derive(config, plane);
          config.contacts.tensile_stiffness_mpa_per_mm = before.k_t;
          config.contacts.shear_stiffness_mpa_per_mm = before.k_s;
          plane = plane == PlaneCondition::stress ? PlaneCondition::strain : PlaneCondition::stress;
        },
}};

}  // namespace
}  // namespace asperity
