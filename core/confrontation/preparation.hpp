#pragma once
#include <optional>
#include <vector>

#include "core/config/mechanism_config.hpp"

namespace asperity {

/// What a laboratory did to a test's specimens that a run has no key for: it changes how a mechanism acts there.
struct Preparation {
  double core_angle_deg = 0.0;      ///< Of the core's axis against the other cores', counter-clockwise, -90 to 90.
  bool lubricated_platens = false;  ///< The specimens' ends slide freely.
  bool operator==(const Preparation&) const = default;
};

/// One after the other: angles add up, a right angle either way.
Preparation both(const Preparation& first, const Preparation& second);

/// The mechanism in a test with such specimens: a weak plane lies at its angle less the
/// core's, and there is no platen friction (nothing) where platens are lubricated.
std::optional<MechanismConfig> acting_in(const Preparation& preparation, MechanismConfig mechanism);

/// Those of the list that act there.
std::vector<MechanismConfig> acting_in(const Preparation& preparation, const std::vector<MechanismConfig>& mechanisms);

}  // namespace asperity
