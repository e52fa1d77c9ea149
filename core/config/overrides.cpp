#include "core/config/overrides.hpp"

#include <algorithm>
#include <optional>

#include "core/config/json_text.hpp"
#include "core/config/schema_lookup.hpp"

namespace asperity {

using nlohmann::json;

namespace {

Fault malformed(const std::string& text) {
  return {"--set", "is not of the form /json/pointer=value", text, "/json/pointer=value",
          "for example --set /particles/edge_mm=1.5"};
}

/// A shell argument as valid UTF-8.
json bare_string(const std::string& text) {
  return json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace));
}

Override parse_override(const std::string& pointer, const std::string& value) {
  ParsedText parsed = parse_json(value, "--set " + pointer);
  if (!parsed.well_formed) return {pointer, bare_string(value), {}};
  for (Fault& fault : parsed.faults) fault.where = pointer + fault.where;
  return {pointer, std::move(parsed.document), std::move(parsed.faults)};
}

/// Names the first token of the pointer that the schema does not know.
Fault unknown_pointer(const json& schema, const Override& item) {
  std::string known;
  for (const std::string& token : pointer_tokens(item.pointer)) {
    const std::string next = child_pointer(known, token);
    if (!schema_at(schema, next)) {
      const json& node = *schema_at(schema, known);
      return {item.pointer, "is not a key of the configuration: " + token, json_text(item.value), allowed_text(node),
              key_hint(schema, known, token)};
    }
    known = next;
  }
  return {};
}

/// Walks to the parent object, making objects on the way. Stops where something stands that is no object: the schema
/// names that fault.
void set_value(json& document, const Override& item) {
  json* node = &document;
  for (const std::string& token : pointer_tokens(item.pointer)) {
    if (node->is_null()) *node = json::object();
    if (!node->is_object()) return;
    node = &(*node)[token];
  }
  *node = item.value;
}

/// The array into which the pointer leads, at whatever depth.
std::optional<std::string> array_above(const json& schema, const std::string& pointer) {
  std::string known;
  for (const std::string& token : pointer_tokens(pointer)) {
    const json* node = schema_at(schema, known);
    if (!node) return std::nullopt;
    const std::vector<std::string> keys = allowed_keys(*node);  // a node may allow an object as well
    if (node->contains("items") && std::find(keys.begin(), keys.end(), token) == keys.end()) return known;
    known = child_pointer(known, token);
  }
  return std::nullopt;
}

Fault inside_array(const json& schema, const Override& item, const std::string& array) {
  return {item.pointer, "is inside an array, which is set as a whole", json_text(item.value),
          allowed_text(*schema_at(schema, array)), "set " + array + " instead, for example " + array + "=[...]"};
}

}  // namespace

std::vector<Override> parse_overrides(const std::vector<std::string>& texts) {
  std::vector<Override> overrides;
  std::vector<Fault> faults;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    const std::string pointer = text.substr(0, equals);
    if (equals == std::string::npos || !is_json_pointer(pointer))
      faults.push_back(malformed(text));
    else
      overrides.push_back(parse_override(pointer, text.substr(equals + 1)));
  }
  if (!faults.empty()) throw Error(ErrorKind::usage, std::move(faults));
  return overrides;
}

std::vector<Fault> apply_overrides(json& document, const json& schema, const std::vector<Override>& overrides) {
  std::vector<Fault> faults;
  for (const Override& item : overrides) {
    faults.insert(faults.end(), item.faults.begin(), item.faults.end());
    if (const auto array = array_above(schema, item.pointer))
      faults.push_back(inside_array(schema, item, *array));
    else if (!schema_at(schema, item.pointer))
      faults.push_back(unknown_pointer(schema, item));
    else
      set_value(document, item);
  }
  return faults;
}

}  // namespace asperity
