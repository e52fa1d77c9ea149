#pragma once
#include <string>

#include "core/config/run_config.hpp"

namespace asperity::app {

/// What a run adds to the base model: "platen_friction (friction_coefficient 0.3); seating (...)"; empty for the base
/// model.
std::string mechanism_words(const RunConfig& config);

}  // namespace asperity::app
