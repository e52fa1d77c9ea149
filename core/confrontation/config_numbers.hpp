#pragma once
#include <optional>
#include <string>

#include "core/config/run_config.hpp"

namespace asperity {

/// The number at a JSON pointer of the run configuration; nothing where it is unset or no number stands there.
std::optional<double> number_of(const RunConfig& config, const std::string& pointer);

/// Sets the number at the pointer of a key, which must be one.
void set_number(RunConfig& config, const std::string& pointer, double value);

}  // namespace asperity
