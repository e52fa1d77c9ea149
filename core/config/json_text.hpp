#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/error.hpp"

namespace asperity {

/// A JSON text after strict parsing.
struct ParsedText {
  nlohmann::json document;    ///< Of a duplicate key the last value; null if the text is not well formed.
  std::vector<Fault> faults;  ///< Syntax (origin:line:column), duplicate keys and numbers too large (JSON pointer).
  bool well_formed = true;
};

/// Parses strict JSON (no comments). Never throws for what the text contains; `origin` names the text in syntax faults.
ParsedText parse_json(std::string text, const std::string& origin);

}  // namespace asperity
