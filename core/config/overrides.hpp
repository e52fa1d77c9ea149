#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/error.hpp"

namespace asperity {

/// One `--set /json/pointer=value`.
struct Override {
  std::string pointer;
  nlohmann::json value;
  std::vector<Fault> faults;  ///< Duplicate keys and numbers too large inside the value.
};

/// Splits the texts "/json/pointer=value"; a value that is not JSON is a bare string. Every malformed text is named in
/// one usage error.
std::vector<Override> parse_overrides(const std::vector<std::string>& texts);

/// Sets the values in the document. Returns the overrides' own faults, and one for each pointer that the schema does
/// not know; these change nothing.
std::vector<Fault> apply_overrides(nlohmann::json& document, const nlohmann::json& schema,
                                   const std::vector<Override>& overrides);

}  // namespace asperity
