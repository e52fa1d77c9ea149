#include "core/confrontation/preparation.hpp"

#include <utility>

#include "core/config/mechanism_declaration.hpp"

namespace asperity {
namespace {

constexpr double kRightAngle = 90.0, kHalfTurn = 180.0;

/// Of a line, which a half turn leaves as it is.
double within_a_right_angle(double angle_deg) {
  if (angle_deg > kRightAngle) return angle_deg - kHalfTurn;
  return angle_deg < -kRightAngle ? angle_deg + kHalfTurn : angle_deg;
}

}  // namespace

Preparation both(const Preparation& first, const Preparation& second) {
  return {within_a_right_angle(first.core_angle_deg + second.core_angle_deg),
          first.lubricated_platens || second.lubricated_platens};
}

std::optional<MechanismConfig> acting_in(const Preparation& preparation, MechanismConfig mechanism) {
  if (mechanism.type == "platen_friction" && preparation.lubricated_platens) return std::nullopt;
  if (mechanism.type == "weak_plane" && !is_off(mechanism) && preparation.core_angle_deg != 0.0) {
    const double angle = mechanism_values(*find_mechanism(mechanism.type), mechanism).at("angle_deg");
    mechanism.parameters["angle_deg"] = within_a_right_angle(angle - preparation.core_angle_deg);
  }
  return mechanism;
}

std::vector<MechanismConfig> acting_in(const Preparation& preparation, const std::vector<MechanismConfig>& mechanisms) {
  std::vector<MechanismConfig> acting;
  for (const MechanismConfig& m : mechanisms) {
    if (auto there = acting_in(preparation, m)) acting.push_back(std::move(*there));
  }
  return acting;
}

}  // namespace asperity
