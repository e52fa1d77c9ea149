#include <algorithm>
#include <cmath>

#include "core/contact/closed_forms.hpp"
#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

using enum ExperimentType;

/// Strengths by a factor and energies by its square: separations grow alike.
void scale_strengths(ContactConfig& contacts, double fracture_energy, double factor) {
  contacts.tensile_strength_mpa *= factor;
  contacts.cohesion_mpa *= factor;
  contacts.fracture_energy_n_per_mm = factor * factor * fracture_energy;
  if (contacts.shear_fracture_energy_n_per_mm) *contacts.shear_fracture_energy_n_per_mm *= factor * factor;
}

/// Eq. (X8). Contacts are stronger the faster the test, by decades of its rate.
const Registered kEntry{{
    .declaration =
        {.id = "rate_strengthening",
         .title = "strength that grows with the loading rate",
         .equation = "(X8) t_c, c_c times 1 + b log10(v / v_ref), v the rate of the test; G_f times its square, so "
                     "that the softening range stays",
         .source =
             "Zhao 2000, Int. J. Rock Mech. 37, 1115-1121; Blanton 1981 (3 to 8 % per decade of quasi-static rates)",
         .reason =
             "b = 0.05 per decade, and one decade above the reference: seen on rock and mortar at quasi-static rates",
         .expectation = "all strengths up by one factor: seen only with two rates",
         .acts_in = {uniaxial, triaxial, brazilian, direct_shear},
         .parameters = {{.key = "per_decade",
                         .unit = "1",
                         .description = "Relative strength gained in a decade of rate",
                         .lowest = 0.0,
                         .highest = 0.5,
                         .strong = 0.05,
                         .neutral = 0.0},
                        {.key = "reference_rate_mm_per_s",
                         .unit = "mm/s",
                         .description = "Rate at which the strengths are those of the file",
                         .lowest = 1e-06,
                         .highest = 100000.0,
                         .strong = 10.0}},
         .needs_breakable_particles = true,
         .allows_elastic_start = true},
    .set =
        [](const MechanismValues& value, RunConfig& config) {
          const LoadingConfig& loading = config.experiment.loading;
          const bool shear = config.experiment.type == direct_shear;
          const double rate = shear ? loading.shear_rate_mm_per_s : loading.closing_rate_mm_per_s;
          const double factor =
              std::max(0.1, 1.0 + value("per_decade") * std::log10(rate / value("reference_rate_mm_per_s")));
          scale_strengths(config.contacts, derive(config, config.experiment.plane).g_f, factor);
        },
}};

}  // namespace
}  // namespace asperity
