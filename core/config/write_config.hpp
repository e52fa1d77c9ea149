#pragma once
#include <string>
#include <string_view>

#include "core/config/run_config.hpp"

namespace asperity {

/// The configuration in force as JSON text, with every key that has a meaning in it, defaults included, in the order of
/// bindings(). Optional members that are unset are left out. parse_run_config reads it back to the same RunConfig.
std::string effective_json(const RunConfig& config);

/// 128-bit FNV-1a of the effective configuration without its name and description, as 32 hexadecimal digits: equal
/// configurations give equal results.
std::string config_hash(const RunConfig& config);

/// 128-bit FNV-1a of a text (Fowler, Noll, Vo) as 32 hexadecimal digits.
std::string fnv1a_128(std::string_view text);

}  // namespace asperity
