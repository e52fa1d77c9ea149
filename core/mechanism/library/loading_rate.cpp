#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

using enum ExperimentType;

/// Eq. (X22). Suspect: the simulation's loading rate.
const Registered kEntry{{
    .declaration = {.id = "loading_rate",
                    .title = "rate of the simulated test",
                    .equation = "(X22) closing and shear rate times a factor",
                    .source = "this project's measurements: half the rate lowers uniaxial peaks by some percent",
                    .reason = "half the rate: a test that is quasi-static does not see it",
                    .expectation = "peaks down where the rate was too high",
                    .acts_in = {uniaxial, triaxial, brazilian, direct_shear},
                    .parameters = {{.key = "rate_factor",
                                    .unit = "1",
                                    .description = "Of the loading rate",
                                    .lowest = 0.05,
                                    .highest = 4.0,
                                    .strong = 0.5,
                                    .neutral = 1.0}},
                    .suspect = true,
                    .allows_elastic_start = true},
    .set =
        [](const MechanismValues& value, RunConfig& config) {
          LoadingConfig& loading = config.experiment.loading;
          (config.experiment.type == direct_shear ? loading.shear_rate_mm_per_s : loading.closing_rate_mm_per_s) *=
              value("rate_factor");
        },
}};

}  // namespace
}  // namespace asperity
