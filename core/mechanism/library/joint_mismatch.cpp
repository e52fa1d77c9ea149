#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

using enum ExperimentType;

/// Eq. (X16). The upper half does not lie where it fits; E22 of core/experiment.
const Registered kEntry{{
    .declaration = {.id = "joint_mismatch",
                    .title = "halves of the joint that do not mate",
                    .equation =
                        "(X16) the upper half is shifted along the joint by a gap and lifted until it touches, E22",
                    .source = "Zhao 1997, Int. J. Rock Mech. 34, 173-178 (joint matching coefficient)",
                    .reason = "0.5 mm: a tenth of the tooth's height, what relocating by hand leaves",
                    .expectation = "joint stiffness down, peak later, early dilation down",
                    .acts_in = {direct_shear},
                    .parameters = {{.key = "gap_mm",
                                    .unit = "mm",
                                    .description =
                                        "Shift of the upper half in the direction in which the lower one is driven",
                                    .lowest = 0.0,
                                    .highest = 10.0,
                                    .strong = 0.5,
                                    .neutral = 0.0}}},
    .set = [](const MechanismValues& value, RunConfig& config) { config.extensions.mismatch_mm = value("gap_mm"); },
}};

}  // namespace
}  // namespace asperity
