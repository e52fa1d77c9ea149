#include "core/contact/closed_forms.hpp"
#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

using enum ExperimentType;

/// Eq. (X21). Suspect: the particles' size.
const Registered kEntry{{
    .declaration = {.id = "mesh_size",
                    .title = "size of the particles",
                    .equation = "(X21) edge_mm and its deviation times a factor; contact stiffness over it",
                    .source = "Potyondy & Cundall 2004; the audit's figures (the paper's edge is its zone's thickness)",
                    .reason = "a quarter larger: what two meshers make of one nominal size",
                    .expectation = "strengths shift by a few percent",
                    .acts_in = {uniaxial, triaxial, brazilian, direct_shear},
                    .parameters = {{.key = "edge_factor",
                                    .unit = "1",
                                    .description = "Of the edge length",
                                    .lowest = 0.5,
                                    .highest = 2.0,
                                    .strong = 1.25,
                                    .neutral = 1.0}},
                    .suspect = true,
                    .allows_elastic_start = true},
    .set =
        [](const MechanismValues& value, RunConfig& config) {
          const double factor = value("edge_factor");
          const DerivedParameters before = derive(config, config.experiment.plane);
          config.contacts.tensile_stiffness_mpa_per_mm = before.k_t / factor;
          config.contacts.shear_stiffness_mpa_per_mm = before.k_s / factor;
          config.particles.edge_mm *= factor;
          if (config.particles.edge_deviation_mm) *config.particles.edge_deviation_mm *= factor;
        },
}};

}  // namespace
}  // namespace asperity
