#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// The JSON Schema (draft 7) of one kind of configuration, e.g. "run", as configs/schema/KIND.schema.json has it. An
/// unknown kind is a usage error.
const std::string& schema_text(std::string_view kind);

/// The kinds that schema_text knows.
std::vector<std::string> schema_kinds();

}  // namespace asperity
