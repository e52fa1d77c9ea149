#include <numbers>

#include "core/contact/closed_forms.hpp"
#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

using enum ExperimentType;

/// Eq. (X3). Shear softens linearly behind its peak, Eq. D9, where the base model drops.
const Registered kEntry{{
    .declaration = {.id = "shear_softening",
                    .title = "softening in shear behind the contact's peak",
                    .equation =
                        "(X3) G_II = c_c delta_cs (e - 2) + r G_I, the paper's Eq. 10 with shear's own peak: Eq. D9",
                    .source = "Rice 1980 (Enrico Fermi School), slip weakening of intact rock; Wong 1982, Mech. Mater. "
                              "1, 3-17 (G_II of 2 to 60 times G_I)",
                    .reason = "r = 1: energies of shear fracture measured on rock are never below those of tension",
                    .expectation = "smaller drop, peaks up 5 to 15 %, the joint fails later",
                    .acts_in = {uniaxial, triaxial, brazilian, direct_shear},
                    .parameters = {{.key = "energy_ratio",
                                    .unit = "1",
                                    .description = "Fracture energy of shear behind its peak over that of tension",
                                    .lowest = 0.0,
                                    .highest = 60.0,
                                    .strong = 1.0,
                                    .neutral = 0.0}},
                    .default_law_only = true,
                    .needs_breakable_particles = true,
                    .allows_elastic_start = true},
    .set =
        [](const MechanismValues& value, RunConfig& config) {
          const DerivedParameters d = derive(config, config.experiment.plane);
          const double hardening = config.contacts.cohesion_mpa * d.delta_cs * (std::numbers::e - 2.0);
          const double present = config.contacts.shear_fracture_energy_n_per_mm.value_or(hardening);
          config.contacts.shear_fracture_energy_n_per_mm = present + value("energy_ratio") * d.g_f;
        },
}};

}  // namespace
}  // namespace asperity
