#pragma once
#include <nlohmann/json.hpp>
#include <vector>

#include "core/base/error.hpp"

namespace asperity {

/// Validates a document against a JSON Schema (draft 7, without $ref). Returns one fault for each unknown key and at
/// most one for any other value, each with its JSON pointer, the value, what the schema allows and a hint.
std::vector<Fault> schema_faults(const nlohmann::json& document, const nlohmann::json& schema);

}  // namespace asperity
