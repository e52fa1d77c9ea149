#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

using enum ExperimentType;

/// Eq. (X7). A joint's surfaces wear as they slide under pressure, Eqs. C55, C56.
const Registered kEntry{{
    .declaration =
        {.id = "joint_wear",
         .title = "friction of the joint that falls with slip under pressure",
         .equation = "(X7) tan(phi_j) (r + (1 - r) exp(-w / s_c)), dw = ds p / p_ref: Eqs. C55, C56",
         .source =
             "Plesha 1987, Int. J. Numer. Anal. Methods Geomech. 11, 345-362 (damage by frictional work); Archard 1953",
         .reason = "r = 0.8 over 2 mm at 1 MPa: saw-cut surfaces lose 5 to 8 degrees of friction in a first pass",
         .expectation = "residual and late dilation down, most at high normal stress",
         .acts_in = {direct_shear},
         .parameters = {{.key = "residual_share",
                         .unit = "1",
                         .description = "Of tan(phi_j) that is left in the end",
                         .lowest = 0.0,
                         .highest = 1.0,
                         .strong = 0.8,
                         .neutral = 1.0},
                        {.key = "slip_mm",
                         .unit = "mm",
                         .description = "Slip of the exponential at the reference stress",
                         .lowest = 0.0001,
                         .highest = 100.0,
                         .strong = 2.0},
                        {.key = "reference_stress_mpa",
                         .unit = "MPa",
                         .description = "Normal stress at which slip counts once",
                         .lowest = 0.01,
                         .highest = 100.0,
                         .strong = 1.0}},
         .needs_general_contact = true},
    .set =
        [](const MechanismValues& value, RunConfig& config) {
          config.extensions.outline_wear = {value("residual_share"), value("slip_mm"), value("reference_stress_mpa")};
        },
}};

}  // namespace
}  // namespace asperity
