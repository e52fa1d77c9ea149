#include <cmath>

#include "core/base/units.hpp"
#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

using enum ExperimentType;

/// Eq. (X20). Particles yield, Eq. P7.
const Registered kEntry{{
    .declaration = {.id = "particle_plasticity",
                    .title = "particles that yield",
                    .equation = "(X20) |sigma_1 - sigma_2| <= Y in the plane, slip at constant area: Eq. P7",
                    .source = "Tresca; Wong & Baud 2012, J. Struct. Geol. 44, 25-53 (brittle-ductile transition)",
                    .reason =
                        "Y a fifth above the uniaxial strength that the contacts' Coulomb line gives: porous rock "
                        "and plaster flow at confining pressures of a tenth of that strength",
                    .expectation = "triaxial strain at peak up, the joint's dilation down",
                    .acts_in = {uniaxial, triaxial, brazilian, direct_shear},
                    .parameters = {{.key = "yield_over_strength",
                                    .unit = "1",
                                    .description =
                                        "Y over 2 c_c tan(45 deg + phi_c/2), the contacts' uniaxial strength",
                                    .lowest = 0.05,
                                    .highest = 1000.0,
                                    .strong = 1.2,
                                    .reciprocal = true}},
                    .needs_breakable_particles = true},
    .set =
        [](const MechanismValues& value, RunConfig& config) {
          const ContactConfig& c = config.contacts;
          const double friction = config.extensions.peak_friction_angle_deg.value_or(c.friction_angle_deg);
          const double slope = std::tan((45.0 + 0.5 * friction) * units::kRadPerDeg);
          config.extensions.yield_stress_mpa = value("yield_over_strength") * 2.0 * c.cohesion_mpa * slope;
        },
}};

}  // namespace
}  // namespace asperity
