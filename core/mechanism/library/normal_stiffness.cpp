#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

using enum ExperimentType;

/// Eq. (X17). A spring above the upper half resists dilation; E23 of core/experiment.
const Registered kEntry{{
    .declaration = {.id = "normal_stiffness",
                    .title = "normal stiffness above the joint",
                    .equation = "(X17) sigma_n = sigma_n0 + K_n v, v the dilation of the upper block, E23",
                    .source = "Leichnitz 1985, Int. J. Rock Mech. 22, 313-321; Skinas, Bandis & Demiris 1990 (constant "
                              "normal stiffness)",
                    .reason = "0.5 MPa/mm: the stiffness of rock around a joint of this length, and of the air or "
                              "springs of a shear box gone stiff",
                    .expectation = "peak and residual up with dilation, most at low normal stress",
                    .acts_in = {direct_shear},
                    .parameters = {{.key = "normal_stiffness_mpa_per_mm",
                                    .unit = "MPa/mm",
                                    .description = "Normal stress per dilation, on the joint's plan area",
                                    .lowest = 0.0,
                                    .highest = 100000.0,
                                    .strong = 0.5,
                                    .neutral = 0.0}}},
    .set =
        [](const MechanismValues& value, RunConfig& config) {
          config.extensions.normal_stiffness_mpa_per_mm = value("normal_stiffness_mpa_per_mm");
        },
}};

}  // namespace
}  // namespace asperity
