#include <cmath>

#include "core/base/units.hpp"
#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

using enum ExperimentType;

/// Eq. (X4). The intact contact's shear strength bends over with pressure, Eq. D10, towards a friction below its slope.
const Registered kEntry{{
    .declaration =
        {.id = "curved_envelope",
         .title = "curved shear envelope of the contacts",
         .equation = "(X4) S(p) = c_c (1 + p tan(phi_c) / (n c_c))^n, slope tan(phi_c) at p = 0: Eq. D10; the "
                     "broken contact's friction is a share of that slope, and S is never below it",
         .source =
             "Hoek & Brown 1980, J. Geotech. Eng. 106, 1013-1035; Hobbs 1970, J. Mech. Phys. Solids 18 (power law); "
             "Byerlee 1978, Pure Appl. Geophys. 116 (friction of fractures)",
         .reason = "n = 0.6: the exponents fitted to rock envelopes lie between 0.5 and 0.8; share 0.3: intact "
                   "envelopes begin at 50 "
                   "to 60 degrees and end at 25 to 30 (Hoek-Brown, m = 15 to 25, up to half the strength)",
         .expectation = "the triaxial slope falls with confining pressure",
         .acts_in = {uniaxial, triaxial, brazilian, direct_shear},
         .parameters = {{.key = "exponent",
                         .unit = "1",
                         .description = "Of the strength over the pressure; 1 is straight",
                         .lowest = 0.4,
                         .highest = 1.0,
                         .strong = 0.6,
                         .neutral = 1.0},
                        {.key = "friction_share",
                         .unit = "1",
                         .description = "Friction of the broken contact over the slope of the intact one's strength",
                         .lowest = 0.2,
                         .highest = 1.0,
                         .strong = 0.3,
                         .neutral = 1.0}},
         .default_law_only = true,
         .needs_breakable_particles = true,
         .allows_elastic_start = true},
    .set =
        [](const MechanismValues& value, RunConfig& config) {
          config.extensions.envelope_exponent = value("exponent");
          double& friction = config.contacts.friction_angle_deg;
          if (!config.extensions.peak_friction_angle_deg) config.extensions.peak_friction_angle_deg = friction;
          const double slope = std::tan(friction * units::kRadPerDeg);
          friction = std::atan(value("friction_share") * slope) / units::kRadPerDeg;
        },
}};

}  // namespace
}  // namespace asperity
