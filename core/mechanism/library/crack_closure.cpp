#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

using enum ExperimentType;

/// Eq. (X5). Contacts are softer in compression until they have closed, Eq. D11.
const Registered kEntry{{
    .declaration = {.id = "crack_closure",
                    .title = "closing of fine cracks at the contacts",
                    .equation = "(X5) p(u) = k_t (u - (1 - r) u d / (u + d)), u the closing of a contact, r = k_0/k_t: "
                                "Eq. D11; reversible",
                    .source = "Walsh 1965, J. Geophys. Res. 70, 399-411; Bandis, Lumsden & Barton 1983, Int. J. Rock "
                              "Mech. 20, 249-268 (hyperbolic closure)",
                    .reason = "r = 0.3 over 0.002 mm: moduli of rock at first loading are 0.2 to 0.5 of those behind "
                              "the toe, and apertures of its cracks some micrometres",
                    .expectation =
                        "a toe in uniaxial compression that fades with confining pressure and stays on reloading",
                    .acts_in = {uniaxial, triaxial, brazilian, direct_shear},
                    .parameters = {{.key = "stiffness_ratio",
                                    .unit = "1",
                                    .description = "Normal stiffness of a contact that begins to close over k_t",
                                    .lowest = 0.05,
                                    .highest = 1.0,
                                    .strong = 0.3,
                                    .neutral = 1.0},
                                   {.key = "closure_length_mm",
                                    .unit = "mm",
                                    .description = "Closing by which half of the missing closure is made",
                                    .lowest = 1e-06,
                                    .highest = 1.0,
                                    .strong = 0.002}},
                    .default_law_only = true,
                    .needs_breakable_particles = true},
    .set =
        [](const MechanismValues& value, RunConfig& config) {
          config.extensions.closure_stiffness_ratio = value("stiffness_ratio");
          config.extensions.closure_length_mm = value("closure_length_mm");
        },
}};

}  // namespace
}  // namespace asperity
