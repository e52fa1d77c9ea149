#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

using enum ExperimentType;

/// Eq. (X15). The upper platen is tilted, or turns about a hinge beside the axis; I24 and I25 of core/integrator.
const Registered kEntry{{
    .declaration =
        {.id = "eccentric_load",
         .title = "tilted platen, load beside the axis",
         .equation = "(X15) the upper face turned by a tilt, I24; with an offset it hangs on a hinge so far from "
                     "the axis, I25",
         .source = "ISRM suggested method for uniaxial compression 1979 (ends perpendicular within 0.001 rad)",
         .reason = "0.15 degrees: 2.6 times the ISRM's limit, a careless cut",
         .expectation = "peak down, the two sides strain differently, a toe",
         .acts_in = {uniaxial, triaxial},
         .parameters = {{.key = "tilt_deg",
                         .unit = "deg",
                         .description = "Of the upper platen against the specimen's end, counter-clockwise",
                         .lowest = -3.0,
                         .highest = 3.0,
                         .strong = 0.15,
                         .neutral = 0.0},
                        {.key = "offset_mm",
                         .unit = "mm",
                         .description =
                             "Of the hinge above the upper platen from the axis; 0: no hinge, the platen cannot turn",
                         .lowest = -20.0,
                         .highest = 20.0,
                         .strong = 0.0,
                         .neutral = 0.0}}},
    .set =
        [](const MechanismValues& value, RunConfig& config) {
          config.extensions.tilt_deg = value("tilt_deg");
          if (value("offset_mm") != 0.0) config.extensions.hinge_offset_mm = value("offset_mm");
        },
}};

}  // namespace
}  // namespace asperity
