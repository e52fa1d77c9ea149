#include "core/config/schema_reference.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <vector>

#include "core/config/applicability.hpp"
#include "core/config/mechanism_declaration.hpp"
#include "core/config/schema.hpp"
#include "core/config/schema_lookup.hpp"

namespace asperity {

using nlohmann::json;
using nlohmann::ordered_json;

namespace {

/// In a pointer, the place of a list's entry or of a name that the user chooses.
constexpr std::string_view kEntry = "N";

/// What stands below a heading's text in an address, as GitHub makes it: small letters, digits, - and _.
std::string anchor(const std::string& heading) {
  std::string text;
  for (const char c : heading) {
    if (c == ' ') text += '-';
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_')
      text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return text;
}

bool has_keys(const ordered_json& node) { return node.contains("properties"); }

bool lists_objects(const ordered_json& node) { return node.contains("items") && has_keys(node.at("items")); }

std::string entry_of(const std::string& pointer) { return pointer + "/" + std::string(kEntry); }

/// "[below](#...)" where the key has a section of its own.
std::string below(const std::string& text, const std::string& pointer) {
  return "[" + text + "](#" + anchor(pointer) + ")";
}

std::string type_word(const std::string& type) {
  static const std::map<std::string, std::string> words{{"number", "number"}, {"integer", "whole number"},
                                                        {"string", "text"},   {"array", "list"},
                                                        {"object", "object"}, {"boolean", "true or false"}};
  const auto found = words.find(type);
  return found == words.end() ? type : found->second;
}

std::string type_cell(const ordered_json& node) {
  const ordered_json& type = node.at("type");
  if (type.is_string()) return type_word(type);
  std::string text;
  for (const ordered_json& one : type) text += (text.empty() ? "" : " or ") + type_word(one);
  return text;
}

/// Number nodes without their unit and type, which have columns of their own.
std::string allowed_cell(const ordered_json& node, const std::string& pointer) {
  if (has_keys(node)) return below("its keys", pointer);
  if (lists_objects(node)) return below("its entries", entry_of(pointer));
  const bool bounded = node.contains("minimum") || node.contains("exclusiveMinimum") || node.contains("maximum") ||
                       node.contains("exclusiveMaximum");
  const bool telling = bounded || node.contains("enum") || node.contains("items") || node.contains("maxLength");
  if (!telling) return "";
  json plain = json::parse(node.dump());
  plain.erase("unit");
  if (plain.at("type") == "integer") plain["type"] = "number";
  return allowed_text(plain);
}

std::string default_cell(const ordered_json& node, bool required) {
  if (required) return "**required**";
  if (node.contains("x-default")) return node.at("x-default");
  return node.contains("default") ? "`" + node.at("default").dump() + "`" : "–";
}

/// Where a run's key has a meaning, in words.
std::string condition(const std::string& pointer) {
  std::string text;
  for (const ConditionalKey& key : conditional_keys())
    if (key.pointer == pointer) text += (text.empty() ? "" : "; ") + std::string(key.allowed);
  if (text.empty()) return text;
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return " *" + text + ".*";
}

/// The description without the unit that messages and editors need in it.
std::string meaning(const ordered_json& node) {
  std::string text = node.value("description", "");
  for (const std::string& end : {" Unit: " + node.value("unit", "1") + ".", std::string(" Dimensionless.")})
    if (text.ends_with(end)) text.resize(text.size() - end.size());
  return text;
}

bool is_required(const ordered_json& node, const std::string& key) {
  const ordered_json required = node.value("required", ordered_json::array());
  return std::find(required.begin(), required.end(), key) != required.end();
}

std::string section(const ordered_json& node, const std::string& pointer, bool run);

/// Sections of what lies below an object: objects and lists of objects, in the schema's order.
std::string sections_below(const ordered_json& node, const std::string& pointer, bool run) {
  std::string text;
  for (const auto& [key, child] : node.at("properties").items()) {
    const std::string there = child_pointer(pointer, key);
    if (has_keys(child)) text += section(child, there, run);
    if (lists_objects(child)) text += section(child.at("items"), entry_of(there), run);
  }
  return text;
}

std::string section(const ordered_json& node, const std::string& pointer, bool run) {
  std::string text = "\n## `" + pointer + "`\n\n" + meaning(node) + "\n\n" + reference_table_head();
  if (run && pointer == entry_of("/mechanisms") && !declared_mechanisms().empty()) {
    ordered_json common = node;  // parameters stand with their mechanism
    common["properties"] = {{"type", node["properties"]["type"]}, {"amplitude", node["properties"]["amplitude"]}};
    common["properties"]["type"]["description"] = "Which mechanism of the library: one of those below.";
    common["properties"]["type"].erase("enum");
    return text + reference_rows(common, pointer, run) + mechanisms_reference();
  }
  return text + reference_rows(node, pointer, run) + sections_below(node, pointer, run);
}

}  // namespace

std::string table_cell(std::string text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '|') text.insert(i++, "\\");
    if (text[i] == '\n') text[i] = ' ';
    if (text[i] == '<') text.replace(i, 1, "&lt;");
  }
  return text;
}

std::string reference_table_head() {
  return "| key | type | unit | allowed | default | meaning |\n|---|---|---|---|---|---|\n";
}

std::string reference_rows(const ordered_json& node, const std::string& pointer, bool run) {
  std::string text;
  for (const auto& [key, child] : node.at("properties").items()) {
    const std::string there = child_pointer(pointer, key);
    const std::string unit = child.value("unit", "1");
    text += "| `" + there + "` | " + type_cell(child) + " | " + (unit == "1" ? "" : unit) + " | " +
            table_cell(allowed_cell(child, there)) + " | " + table_cell(default_cell(child, is_required(node, key))) +
            " | " + table_cell(meaning(child)) + (run ? condition(there) : "") + " |\n";
  }
  return text;
}

std::string schema_reference(const ordered_json& schema, std::string_view kind, bool run) {
  const std::string name(kind);
  return "# " + schema.at("title").get<std::string>() + ": every key\n\n" + meaning(schema) +
         "\n\nMade by `asperity schema " + name + " --markdown` from [configs/schema/" + name +
         ".schema.json](../../configs/schema/" + name + ".schema.json); a test holds this page equal to what the " +
         "command writes. A key is named by its JSON pointer, as `--set` takes it; `" + std::string(kEntry) +
         "` stands for the place of a list's entry, counted from 0.\n\n" + reference_table_head() +
         reference_rows(schema, "", run) + sections_below(schema, "", run);
}

std::string schema_reference(std::string_view kind) {
  return schema_reference(ordered_json::parse(schema_text(kind)), kind, kind == "run");
}

}  // namespace asperity
