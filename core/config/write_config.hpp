#pragma once
#include <string>
#include <string_view>

#include "core/config/run_config.hpp"

namespace asperity {

/// The configuration in force as JSON text, with every key that has a meaning in it, defaults included, in the order of
/// bindings(). Optional members that are unset are left out. parse_run_config reads it back to the same RunConfig.
std::string effective_json(const RunConfig& config);

/// SHA-256, as 64 hexadecimal digits, of the effective configuration without what changes no result (name, description,
/// checkpoint interval): equal hashes give equal results.
std::string config_hash(const RunConfig& config);

}  // namespace asperity
