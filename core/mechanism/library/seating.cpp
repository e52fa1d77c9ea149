#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

using enum ExperimentType;

/// Eq. (X14). Ends and seats close under the first load and stay closed; E21 of core/experiment.
const Registered kEntry{{
    .declaration =
        {.id = "seating",
         .title = "seating of the specimen's ends",
         .equation = "(X14) closing u_0 s / (s + s_0) at the largest stress s so far, never given back, E21",
         .source =
             "ISRM suggested methods (the toe that is cut off); Goodman 1976 (hyperbolic closure of unmated surfaces)",
         .reason = "0.1 mm, half of it at 1 MPa: ends flat to the ISRM's 0.02 mm on either side, capping and spherical "
                   "seat with them",
         .expectation = "a toe in all tests, gone on reloading",
         .acts_in = {uniaxial, triaxial, brazilian, direct_shear},
         .parameters = {{.key = "seating_mm",
                         .unit = "mm",
                         .description = "Closing under a load without bound",
                         .lowest = 0.0,
                         .highest = 5.0,
                         .strong = 0.1,
                         .neutral = 0.0},
                        {.key = "half_stress_mpa",
                         .unit = "MPa",
                         .description = "Nominal stress at which half of it has closed",
                         .lowest = 0.001,
                         .highest = 100.0,
                         .strong = 1.0}}},
    .set =
        [](const MechanismValues& value, RunConfig& config) {
          config.extensions.seating_mm = value("seating_mm");
          config.extensions.seating_stress_mpa = value("half_stress_mpa");
        },
}};

}  // namespace
}  // namespace asperity
