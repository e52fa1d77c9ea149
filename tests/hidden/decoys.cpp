#include "core/base/random.hpp"
#include "core/mechanism/mechanism.hpp"

/// Entries for the executable of the hidden effects' tests alone: two that change nothing, and one that is another's
/// twin.
namespace asperity {
namespace {

using enum ExperimentType;

MechanismParameter turned(std::string key, double strong) {
  return {.key = std::move(key),
          .unit = "1",
          .description = "How far it is turned",
          .lowest = 0.0,
          .highest = 5.0,
          .strong = strong,
          .neutral = 0.0};
}

Mechanism entry(std::string id, std::string title, MechanismParameter parameter) {
  Mechanism made;
  made.declaration = {.id = std::move(id),
                      .title = std::move(title),
                      .equation = "none of the model",
                      .source = "tests of hidden effects",
                      .reason = "a test's",
                      .expectation = "nothing that no other entry does",
                      .acts_in = {uniaxial, triaxial, brazilian, direct_shear},
                      .parameters = {std::move(parameter)}};
  return made;
}

/// Changes a number that no result depends on: its fingerprint is exactly zero.
Mechanism idle() {
  Mechanism made = entry("decoy_idle", "a knob that is not connected", turned("idle_turn", 1.0));
  made.set = [](const MechanismValues& value, RunConfig& config) {
    config.output.width_px += static_cast<int>(value("idle_turn"));
  };
  return made;
}

/// Strengths that differ by a thousandth from contact to contact: other runs, the same means.
Mechanism flicker() {
  Mechanism made = entry("decoy_flicker", "a knob that only shakes", turned("flicker_share", 0.001));
  made.mark = [](const MechanismValues& value, const ContactSite& site, ContactMarks& marks) {
    RandomStream stream(site.config.particles.seed, "decoy_flicker");
    for (double& strength : marks.strength) strength *= 1.0 + value("flicker_share") * (2.0 * stream.uniform() - 1.0);
  };
  return made;
}

/// frame_compliance under another name.
Mechanism twin() {
  Mechanism made = entry("decoy_twin", "the frame's compliance once more", turned("twin_compliance_mm_per_n", 0.002));
  made.set = [](const MechanismValues& value, RunConfig& config) {
    config.extensions.frame_stiffness_n_per_mm = 1.0 / value("twin_compliance_mm_per_n");
  };
  return made;
}

const Registered kIdle{idle()}, kFlicker{flicker()}, kTwin{twin()};

}  // namespace
}  // namespace asperity
