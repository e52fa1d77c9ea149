#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

using enum ExperimentType;

/// Eq. (X1). The friction of a specimen's ends on the platens, Eq. I6.
const Registered kEntry{{
    .declaration =
        {.id = "platen_friction",
         .title = "friction between specimen and platens",
         .equation = "(X1) |t_s| <= mu p at every node that presses a platen, elastic slip below it, Eq. I6",
         .source = "Hawkes & Mellor 1970, Eng. Geol. 4, 177-285; Coulomb",
         .reason = "mu = 0.3: dry rock or plaster on ground steel, 0.2 to 0.4; lubricated ends have 0.02 to 0.1",
         .expectation = "uniaxial peak up, softer drop; less of both under confinement; hardly any on a disc",
         .acts_in = {uniaxial, triaxial, brazilian},
         .parameters = {{.key = "friction_coefficient",
                         .unit = "1",
                         .description = "Coulomb coefficient of the ends on the platens",
                         .lowest = 0.0,
                         .highest = 2.0,
                         .strong = 0.3,
                         .neutral = 0.0}}},
    .set = [](const MechanismValues& value,
              RunConfig& config) { config.experiment.platens.friction_coefficient = value("friction_coefficient"); },
}};

}  // namespace
}  // namespace asperity
