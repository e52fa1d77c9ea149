#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

using enum ExperimentType;

/// Eq. (X13). The drive reaches the platens, or the shear box, through a spring; E20 of core/experiment.
const Registered kEntry{{
    .declaration =
        {.id = "frame_compliance",
         .title = "compliance of the loading frame",
         .equation = "(X13) F = K (u_drive - u_platen), E20; what is measured as closure is the drive's",
         .source =
             "Salamon 1970, Int. J. Rock Mech. 7, 613-631; Hudson, Crouch & Fairhurst 1972, Eng. Geol. 6, 155-189",
         .reason = "as stiff as the strong case's specimen per mm of thickness, 500 N/mm: soft frames reach no more "
                   "than their specimen",
         .expectation = "modulus down, strain at peak up, a sharper drop; strengths the same",
         .acts_in = {uniaxial, triaxial, brazilian, direct_shear},
         .parameters = {{.key = "stiffness_n_per_mm",
                         .unit = "N/mm",
                         .description = "Of frame and load cell, for a specimen as thick as thickness_mm",
                         .lowest = 1.0,
                         .highest = 1000000000.0,
                         .strong = 500.0,
                         .reciprocal = true}}},
    .set = [](const MechanismValues& value,
              RunConfig& config) { config.extensions.frame_stiffness_n_per_mm = value("stiffness_n_per_mm"); },
}};

}  // namespace
}  // namespace asperity
