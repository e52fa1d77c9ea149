#pragma once
#include <nlohmann/json.hpp>

#include "core/confrontation/measured_data.hpp"

namespace asperity {

/// The standard deviations by the keys of a measured file, percent or mm as their names say.
nlohmann::ordered_json instrument_json(const Instrument& instrument);

}  // namespace asperity
