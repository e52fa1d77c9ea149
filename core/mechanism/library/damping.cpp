#include <algorithm>

#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

using enum ExperimentType;

/// Eq. (X23). Suspect: the local damping.
const Registered kEntry{{
    .declaration = {.id = "damping",
                    .title = "local damping of the solver",
                    .equation = "(X23) local_damping plus a change, Eq. I3",
                    .source = "Cundall 1987; Potyondy & Cundall 2004 (0.7)",
                    .reason = "0.3 less: the range in use is 0.1 to 0.8",
                    .expectation = "peaks down by 2 to 4 %, more broken in the drop",
                    .acts_in = {uniaxial, triaxial, brazilian, direct_shear},
                    .parameters = {{.key = "damping_change",
                                    .unit = "1",
                                    .description = "Added to local_damping",
                                    .lowest = -0.7,
                                    .highest = 0.25,
                                    .strong = -0.3,
                                    .neutral = 0.0}},
                    .suspect = true,
                    .allows_elastic_start = true},
    .set =
        [](const MechanismValues& value, RunConfig& config) {
          double& damping = config.integration.local_damping;
          damping = std::clamp(damping + value("damping_change"), 0.0, 0.95);
        },
}};

}  // namespace
}  // namespace asperity
