#include "core/base/random.hpp"
#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

using enum ExperimentType;

/// Eq. (X10). Some contacts are open before the test.
const Registered kEntry{{
    .declaration = {.id = "initial_defects",
                    .title = "contacts open from the start",
                    .equation = "(X10) each contact is open with probability f: pressure and friction only",
                    .source = "Bieniawski 1967, Int. J. Rock Mech. 4, 395-430; Potyondy & Cundall 2004, Int. J. Rock "
                              "Mech. 41, 1329-1364",
                    .reason =
                        "f = 0.1: crack densities that lower moduli by some tenths, as in weathered or heated rock",
                    .expectation = "modulus and peak down, a toe",
                    .acts_in = {uniaxial, triaxial, brazilian, direct_shear},
                    .parameters = {{.key = "fraction",
                                    .unit = "1",
                                    .description = "Of the contacts that are open",
                                    .lowest = 0.0,
                                    .highest = 0.6,
                                    .strong = 0.1,
                                    .neutral = 0.0}},
                    .needs_breakable_particles = true},
    .mark =
        [](const MechanismValues& value, const ContactSite& site, ContactMarks& marks) {
          RandomStream stream(site.config.particles.seed, "initial_defects");
          for (std::uint8_t& defect : marks.defects)
            defect |= static_cast<std::uint8_t>(stream.uniform() < value("fraction"));
        },
}};

}  // namespace
}  // namespace asperity
