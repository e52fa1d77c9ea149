#include "core/config/schema_lookup.hpp"

#include <algorithm>
#include <charconv>
#include <map>

#include "core/config/schema.hpp"
#include "core/config/suggest.hpp"

namespace asperity {

using nlohmann::json;

namespace {

std::string join(const std::vector<std::string>& words, const std::string& last_separator) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? last_separator : ", ") + words[i];
  return text;
}

std::string with_unit(const std::string& text, const json& node) {
  const std::string unit = node.value("unit", "1");
  return unit == "1" || text.empty() ? text : text + " " + unit;
}

std::string bound(const json& node, const char* keyword) {
  if (!node.contains(keyword)) return {};
  const json& value = node.at(keyword);
  return value.is_number_float() ? number_text(value.get<double>()) : value.dump();
}

std::string lower_text(const json& node) {
  const std::string above = bound(node, "exclusiveMinimum");
  return above.empty() ? bound(node, "minimum") : "above " + above;
}

/// The range of a number node without its unit: "0 to 1", "above 0, below 1", "0 or more".
std::string range_text(const json& node) {
  const std::string lower = lower_text(node);
  const std::string below = bound(node, "exclusiveMaximum");
  const std::string upper = bound(node, "maximum");
  if (lower.empty() && below.empty() && upper.empty()) return type_text(node);
  if (below.empty() && upper.empty()) return node.contains("minimum") ? lower + " or more" : lower;
  if (lower.empty()) return below.empty() ? "up to " + upper : "below " + below;
  if (!below.empty()) return (node.contains("minimum") ? "from " : "") + lower + ", below " + below;
  return lower + (node.contains("minimum") ? " to " : ", up to ") + upper;
}

std::string words_text(const json& node) {
  std::vector<std::string> words;
  for (const json& word : node.at("enum")) words.push_back(word.dump());
  return join(words, " or ");
}

/// "a string or an array" of a node that allows several types.
std::string union_text(const json& node) {
  std::vector<std::string> types;
  for (const json& type : node.at("type")) types.push_back(type_text({{"type", type}}));
  return join(types, " or ");
}

std::string count_text(const json& node) {
  const std::string least = bound(node, "minItems");
  const std::string most = bound(node, "maxItems");
  if (least == most && !least.empty()) return least + " values";
  return least.empty() ? "a list" : least + " or more values";
}

std::string array_text(const json& node) {
  const std::string unique = node.value("uniqueItems", false) ? ", none twice" : "";
  return count_text(node) + unique + ", each " + allowed_text(node.at("items"));
}

void collect_pointers(const json& node, const std::string& parent, std::vector<std::string>& pointers) {
  for (const std::string& key : allowed_keys(node)) {
    const std::string pointer = child_pointer(parent, key);
    pointers.push_back(pointer);
    collect_pointers(node.at("properties").at(key), pointer, pointers);
  }
}

const json* child_node(const json& node, const std::string& token) {
  if (node.contains("properties") && node.at("properties").contains(token)) return &node.at("properties").at(token);
  const bool is_index =
      !token.empty() && std::all_of(token.begin(), token.end(), [](char c) { return c >= '0' && c <= '9'; });
  return is_index && node.contains("items") ? &node.at("items") : nullptr;
}

/// The pointer of the key, anywhere in the schema, whose last token is nearest; empty if none is near.
std::string nearest_anywhere(const json& schema, const std::string& key) {
  const std::vector<std::string> pointers = schema_pointers(schema);
  std::vector<std::string> names;
  for (const std::string& pointer : pointers) names.push_back(pointer_tokens(pointer).back());
  const auto found = std::find(names.begin(), names.end(), closest(key, names));
  return found == names.end() ? "" : pointers[found - names.begin()];
}

}  // namespace

bool is_json_pointer(const std::string& text) {
  if (!text.starts_with('/')) return false;
  try {
    json::json_pointer{text};
    return true;
  } catch (const json::parse_error&) {
    return false;
  }
}

std::vector<std::string> pointer_tokens(const std::string& pointer) {
  std::vector<std::string> tokens;
  for (json::json_pointer rest(pointer); !rest.empty(); rest.pop_back()) tokens.push_back(rest.back());
  std::reverse(tokens.begin(), tokens.end());
  return tokens;
}

std::string child_pointer(const std::string& parent, std::string_view token) {
  return (json::json_pointer(parent) / std::string(token)).to_string();
}

const json& parsed_schema(std::string_view kind) {
  static const std::map<std::string, json, std::less<>> schemas = [] {
    std::map<std::string, json, std::less<>> parsed;
    for (const std::string& known : schema_kinds()) parsed[known] = json::parse(schema_text(known));
    return parsed;
  }();
  schema_text(kind);  // refuses an unknown kind
  return schemas.find(kind)->second;
}

const json* schema_at(const json& schema, const std::string& pointer) {
  const json* node = &schema;
  for (const std::string& token : pointer_tokens(pointer)) {
    node = child_node(*node, token);
    if (!node) return nullptr;
  }
  return node;
}

std::vector<std::string> schema_pointers(const json& schema) {
  std::vector<std::string> pointers;
  collect_pointers(schema, "", pointers);
  return pointers;
}

std::vector<std::string> allowed_keys(const json& node) {
  std::vector<std::string> keys;
  if (node.contains("properties"))
    for (const auto& [key, child] : node.at("properties").items()) keys.push_back(key);
  return keys;
}

std::string single_type(const json& node) {
  const auto type = node.find("type");
  return type != node.end() && type->is_string() ? type->get<std::string>() : "";
}

std::string type_text(const json& node) {
  if (node.contains("type") && node.at("type").is_array()) return union_text(node);
  static const std::map<std::string, std::string> texts{{"number", "a number"},  {"integer", "a whole number"},
                                                        {"string", "a string"},  {"array", "an array"},
                                                        {"object", "an object"}, {"boolean", "true or false"}};
  const auto found = texts.find(single_type(node));
  return found == texts.end() ? "something else" : found->second;
}

std::string allowed_text(const json& node) {
  const std::string type = single_type(node);
  if (node.contains("enum")) return words_text(node);
  if (type == "array") return with_unit(array_text(node), node);
  if (type == "object" && node.contains("properties"))
    return "an object with the keys " + join(allowed_keys(node), " and ");
  if (type == "string" && node.contains("maxLength"))
    return "a string of up to " + bound(node, "maxLength") + " characters";
  if (type == "integer") return with_unit("whole number, " + range_text(node), node);
  return with_unit(range_text(node), node);
}

std::string key_hint(const json& schema, const std::string& parent, const std::string& key) {
  const json* node = schema_at(schema, parent);
  const std::string sibling = node ? closest(key, allowed_keys(*node)) : "";
  const std::string elsewhere = nearest_anywhere(schema, key);
  if (elsewhere.empty()) return sibling.empty() ? "" : "did you mean " + sibling + "?";  // inside a list's entry
  const std::string name = pointer_tokens(elsewhere).back();
  const bool sibling_as_near = !sibling.empty() && typing_distance(key, sibling) <= typing_distance(key, name);
  return "did you mean " + (sibling_as_near ? sibling : elsewhere) + "?";
}

std::string number_text(double number) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, number).ptr;
  return {buffer, end};
}

std::string json_text(const json& value) {
  constexpr std::size_t kLongest = 80;
  std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
  return text.size() <= kLongest ? text : text.substr(0, kLongest - 3) + "...";
}

}  // namespace asperity
