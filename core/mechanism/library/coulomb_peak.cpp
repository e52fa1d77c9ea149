#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

using enum ExperimentType;

/// Eq. (X2). The peak of the intact contact's shear strength has a friction angle of its own.
const Registered kEntry{{
    .declaration =
        {.id = "coulomb_peak",
         .title = "steeper friction of the intact contact's shear peak",
         .equation = "(X2) tau_peak = c_c + p tan(phi_c + excess) in Eqs. D2, C6; broken contacts keep tan(phi_c)",
         .source = "Hoek & Brown 1980, J. Geotech. Eng. 106, 1013-1035 (intact rock); Byerlee 1978, Pageoph 116, "
                   "615-626 (sliding). The paper's Eq. 6 has no pressure in its peak",
         .reason =
             "15 degrees: intact rock at low confinement has 45 to 60 degrees where its sliding surfaces have 30 to 40",
         .expectation = "the triaxial slope and a joint's peak at high normal stress rise",
         .acts_in = {uniaxial, triaxial, brazilian, direct_shear},
         .parameters = {{.key = "excess_deg",
                         .unit = "deg",
                         .description = "Friction angle of the intact contact's strength over phi_c",
                         .lowest = 0.0,
                         .highest = 40.0,
                         .strong = 15.0,
                         .neutral = 0.0}},
         .needs_breakable_particles = true,
         .allows_elastic_start = true},
    .set =
        [](const MechanismValues& value, RunConfig& config) {
          config.contacts.law.shear_peak = ShearPeak::coulomb;
          std::optional<double>& peak = config.extensions.peak_friction_angle_deg;
          peak = peak.value_or(config.contacts.friction_angle_deg) + value("excess_deg");
        },
}};

}  // namespace
}  // namespace asperity
