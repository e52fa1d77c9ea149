#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

using enum ExperimentType;

/// Eq. (X19). The joint is several strips side by side under one block; E24 of core/experiment.
const Registered kEntry{{
    .declaration =
        {.id = "out_of_plane_strips",
         .title = "strips side by side that fail one by one",
         .equation = "(X19) N strips of equal width, each with its own mesh, between the same two rigid blocks, E24",
         .source =
             "Daniels 1945, Proc. R. Soc. A 183, 405-435 (bundles of threads); the paper's plane model has one strip",
         .reason = "N = 4: a 100 mm wide tooth is four times as wide as its crack front stays straight",
         .expectation = "the double tooth's drop smaller and smoother, by the width",
         .acts_in = {direct_shear},
         .parameters = {{.key = "strips",
                         .unit = "1",
                         .description = "Number of strips",
                         .lowest = 1.0,
                         .highest = 16.0,
                         .strong = 4.0,
                         .neutral = 1.0,
                         .whole = true}}},
    .set = [](const MechanismValues& value,
              RunConfig& config) { config.extensions.strips = static_cast<int>(value("strips")); },
}};

}  // namespace
}  // namespace asperity
