#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>

namespace asperity {

/// The text as JSON, keys in order. Throws nlohmann's exceptions where it is none, and Error(output) that names the
/// file where brackets are nested beyond any sense: what copies a document recurses over its levels.
nlohmann::ordered_json parse_shallow_json(std::string_view text, const std::filesystem::path& name);

}  // namespace asperity
