#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

using enum ExperimentType;

/// Eq. (X18). The upper half may turn against a spring; I26 of core/integrator.
const Registered kEntry{{
    .declaration = {.id = "block_rotation",
                    .title = "rotation of the upper half",
                    .equation = "(X18) moment = K_theta theta about the middle of the upper block, I26",
                    .source = "Jacobsson & Flansbjer 2013; Barton 1976 (rotation in unguided shear boxes)",
                    .reason = "1e5 N mm per rad and mm of thickness: 1 MPa on the rim of a 30 mm half turns it by some "
                              "degrees, an unguided box",
                    .expectation = "the double tooth's drop is smaller, front and rear dilate differently",
                    .acts_in = {direct_shear},
                    .parameters = {{.key = "rotation_stiffness_n_mm_per_rad",
                                    .unit = "N mm/rad",
                                    .description = "Moment per angle, per mm of thickness",
                                    .lowest = 1.0,
                                    .highest = 1000000000000.0,
                                    .strong = 100000.0,
                                    .reciprocal = true}}},
    .set =
        [](const MechanismValues& value, RunConfig& config) {
          config.extensions.rotation_stiffness_n_mm_per_rad = value("rotation_stiffness_n_mm_per_rad");
        },
}};

}  // namespace
}  // namespace asperity
