#pragma once
#include <filesystem>
#include <optional>

#include "core/campaign/campaign_config.hpp"

namespace asperity::app {

/// Draws OUT/plots/envelope.png and .svg where a campaign is one joint in direct shear under three normal stresses or
/// more: peaks and residuals of the finished runs beside Patton's lines, Ladanyi and Archambault's curve and friction
/// on the sheared base. Returns the PNG; nothing for any other campaign, or without the rock's C and phi. Throws
/// Error(output).
std::optional<std::filesystem::path> draw_joint_envelope(const CampaignConfig& campaign,
                                                         const std::vector<CampaignOutcome>& outcomes,
                                                         const std::filesystem::path& out);

}  // namespace asperity::app
