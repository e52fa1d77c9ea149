#include <algorithm>
#include <cmath>

#include "core/base/random.hpp"
#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

using enum ExperimentType;

/// Least strength of a contact, over the mean: none is without any.
constexpr double kLeast = 0.02;

/// Of scale 1, cut off at kLeast.
double weibull(RandomStream& stream, double m) {
  return std::max(kLeast, std::pow(-std::log1p(-stream.uniform()), 1.0 / m));
}

/// Eq. (X9). Contacts differ in strength: a Weibull field of mean 1, Eq. C57.
const Registered kEntry{{
    .declaration = {.id = "strength_scatter",
                    .title = "strengths of the contacts scatter",
                    .equation = "(X9) factor f = w / Gamma(1 + 1/m), P(w < x) = 1 - exp(-x^m), independent from "
                                "contact to contact: Eq. C57",
                    .source = "Weibull 1951, J. Appl. Mech. 18, 293-297; Tang 1997, Int. J. Rock Mech. 34, 249-261",
                    .reason =
                        "m = 3: a variation of 36 %, the usual homogeneity index of rock in such models is 1.5 to 5",
                    .expectation = "uniaxial peak down more than the disc's, early nonlinearity, more scatter",
                    .acts_in = {uniaxial, triaxial, brazilian, direct_shear},
                    .parameters = {{.key = "weibull_modulus",
                                    .unit = "1",
                                    .description = "m of the Weibull law; large means little scatter",
                                    .lowest = 1.0,
                                    .highest = 200.0,
                                    .strong = 3.0,
                                    .reciprocal = true}},
                    .needs_breakable_particles = true},
    .mark =
        [](const MechanismValues& value, const ContactSite& site, ContactMarks& marks) {
          const double m = value("weibull_modulus");
          const double mean = std::tgamma(1.0 + 1.0 / m);
          RandomStream stream(site.config.particles.seed, "strength_scatter");
          for (double& strength : marks.strength) strength *= weibull(stream, m) / mean;
        },
}};

}  // namespace
}  // namespace asperity
