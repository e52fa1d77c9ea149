#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

using enum ExperimentType;

/// Eq. (X6). Fracture surfaces lose friction as they slide, Eq. C55.
const Registered kEntry{{
    .declaration =
        {.id = "slip_weakening",
         .title = "friction of fresh fractures that falls with slip",
         .equation =
             "(X6) tan(phi) = tan(phi_c) (r + (1 - r) exp(-s / s_c)), s the way a fracture surface has slid: Eq. C55",
         .source = "Barton 1976, Int. J. Rock Mech. 13, 255-279; Rice 1980",
         .reason = "r = 0.6 over 0.1 mm: phi from 36 to 24 degrees, gouge against a fresh fracture; the length is that "
                   "of fine grains",
         .expectation = "the residual falls with slip; peaks hardly change",
         .acts_in = {uniaxial, triaxial, brazilian, direct_shear},
         .parameters = {{.key = "residual_share",
                         .unit = "1",
                         .description = "Of tan(phi_c) that is left after long slip",
                         .lowest = 0.0,
                         .highest = 1.0,
                         .strong = 0.6,
                         .neutral = 1.0},
                        {.key = "slip_mm",
                         .unit = "mm",
                         .description = "Slip of the exponential",
                         .lowest = 0.0001,
                         .highest = 100.0,
                         .strong = 0.1}},
         .needs_general_contact = true,
         .needs_breakable_particles = true,
         .allows_elastic_start = true},
    .set =
        [](const MechanismValues& value, RunConfig& config) {
          config.extensions.fracture_wear = {value("residual_share"), value("slip_mm"), 0.0};
        },
}};

}  // namespace
}  // namespace asperity
