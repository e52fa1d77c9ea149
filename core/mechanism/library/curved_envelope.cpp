#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

using enum ExperimentType;

/// Eq. (X4). The intact contact's shear strength bends over with pressure, and so does its friction once broken: Eqs.
/// D10, C58.
const Registered kEntry{{
    .declaration =
        {.id = "curved_envelope",
         .title = "curved shear envelope of the contacts",
         .equation = "(X4) S(p) = c_c (1 + p tan(phi_c) / (n c_c))^n, slope tan(phi_c) at p = 0: Eq. D10; friction of "
                     "what is broken is S(p) - c_c, the strength without its cohesion: Eqs. D10, C58",
         .source =
             "Hoek & Brown 1980, J. Geotech. Eng. 106, 1013-1035; Hobbs 1970, J. Mech. Phys. Solids 18 (power law); "
             "Barton 1976, Int. J. Rock Mech. 13, 255-279 (fractures' friction falls with pressure)",
         .reason = "n = 0.6: the exponents fitted to rock envelopes lie between 0.5 and 0.8",
         .expectation = "the triaxial slope falls with confining pressure",
         .acts_in = {uniaxial, triaxial, brazilian, direct_shear},
         .parameters = {{.key = "exponent",
                         .unit = "1",
                         .description = "Of strength and friction over the pressure; 1 is straight",
                         .lowest = 0.4,
                         .highest = 1.0,
                         .strong = 0.6,
                         .neutral = 1.0}},
         .default_law_only = true,
         .needs_breakable_particles = true,
         .allows_elastic_start = true},
    .set = [](const MechanismValues& value,
              RunConfig& config) { config.extensions.envelope_exponent = value("exponent"); },
}};

}  // namespace
}  // namespace asperity
