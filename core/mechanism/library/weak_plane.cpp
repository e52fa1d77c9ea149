#include <cmath>

#include "core/base/units.hpp"
#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

using enum ExperimentType;

/// Eq. (X11). Contacts along one direction are weaker.
const Registered kEntry{{
    .declaration = {.id = "weak_plane",
                    .title = "weakness along one direction",
                    .equation = "(X11) factor 1 - (1 - f) cos^8(theta - alpha), theta the contact's direction: half "
                                "the loss at 23.5 degrees",
                    .source = "Jaeger 1960, Geol. Mag. 97, 65-72; McLamore & Gray 1967, J. Eng. Ind. 89, 62-73",
                    .reason = "f = 0.5 at 60 degrees to the horizontal: bedding of shale and schist halves the "
                              "strength in its worst direction",
                    .expectation = "strength depends on the direction of loading",
                    .acts_in = {uniaxial, triaxial, brazilian, direct_shear},
                    .parameters = {{.key = "strength_ratio",
                                    .unit = "1",
                                    .description = "Strength of a contact along the plane over that across it",
                                    .lowest = 0.05,
                                    .highest = 1.0,
                                    .strong = 0.5,
                                    .neutral = 1.0},
                                   {.key = "angle_deg",
                                    .unit = "deg",
                                    .description = "Direction of the plane from the x axis, counter-clockwise",
                                    .lowest = -90.0,
                                    .highest = 90.0,
                                    .strong = 60.0}},
                    .needs_breakable_particles = true},
    .mark =
        [](const MechanismValues& value, const ContactSite& site, ContactMarks& marks) {
          const double angle = value("angle_deg") * units::kRadPerDeg, loss = 1.0 - value("strength_ratio");
          for (std::size_t c = 0; c < site.contacts.size(); ++c) {
            const Vec2 along = reference_frame(site.contacts.edges[c], site.particles).tangent;
            const double cosine = along.x * std::cos(angle) + along.y * std::sin(angle);
            marks.strength[c] *= 1.0 - loss * std::pow(cosine * cosine, 4);
          }
        },
}};

}  // namespace
}  // namespace asperity
