#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

using enum ExperimentType;

/// A casting that settled while it set is stronger at its foot than at its head.
const Registered kEntry{{
    .declaration = {.id = "settled_casting",
                    .title = "strength that falls from foot to head",
                    .equation = "factor 1 + g (1/2 - y/H) on the strengths of a contact at height y",
                    .source = "our laboratory, report 12",
                    .reason = "g = 0.3: cores from foot and head of one block differed by 30 %",
                    .expectation = "failure moves to the head; the peak falls",
                    .acts_in = {uniaxial, triaxial},
                    .parameters = {{.key = "gradient",
                                    .unit = "1",
                                    .description = "Relative difference of strength between foot and head",
                                    .lowest = 0.0,
                                    .highest = 1.5,
                                    .strong = 0.3,
                                    .neutral = 0.0}}},
    .mark =
        [](const MechanismValues& value, const ContactSite& site, ContactMarks& marks) {
          const double height = site.config.experiment.height_mm;
          for (std::size_t c = 0; c < site.contacts.size(); ++c) {
            const double y = site.particles.reference(site.contacts.edges[c].left1).y;
            marks.strength[c] *= 1.0 + value("gradient") * (0.5 - y / height);
          }
        },
}};

}  // namespace
}  // namespace asperity
