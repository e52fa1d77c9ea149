#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

/// What the messages need to know from a JSON Schema: the node behind a JSON pointer, its range in words, near keys.
namespace asperity {

/// Whether the text is a JSON pointer to something inside a document: it begins with a slash, and every ~ with 0 or 1.
bool is_json_pointer(const std::string& text);

/// The tokens of a JSON pointer, unescaped; "" has none. A malformed pointer throws nlohmann's parse_error.
std::vector<std::string> pointer_tokens(const std::string& pointer);

/// `parent` with one more token, escaped.
std::string child_pointer(const std::string& parent, std::string_view token);

/// The parsed schema of one kind (see schema_text).
const nlohmann::json& parsed_schema(std::string_view kind);

/// The schema node of the value at a JSON pointer; nullptr if the schema has no such key.
const nlohmann::json* schema_at(const nlohmann::json& schema, const std::string& pointer);

/// The JSON pointers of every key below the schema's root, objects and leaves, in the order of the schema's keys.
std::vector<std::string> schema_pointers(const nlohmann::json& schema);

/// The keys that an object node allows.
std::vector<std::string> allowed_keys(const nlohmann::json& node);

/// The node's "type" where it names one; empty where it names several or none.
std::string single_type(const nlohmann::json& node);

/// The node's type in words, e.g. "a number".
std::string type_text(const nlohmann::json& node);

/// What the node allows, in words with its unit: "above 0, up to 10000 mm", or "\"stress\" or \"strain\"".
std::string allowed_text(const nlohmann::json& node);

/// "did you mean diameter_mm?" for a mistyped key of the object at `parent`, by the nearest sibling or the nearest key
/// anywhere in the schema (then by its pointer); empty if none is near.
std::string key_hint(const nlohmann::json& schema, const std::string& parent, const std::string& key);

/// The shortest text that reads back to the same number: 500, 0.25, 1e-07.
std::string number_text(double number);

/// A JSON value for a message: as JSON, cut if it is long.
std::string json_text(const nlohmann::json& value);

}  // namespace asperity
