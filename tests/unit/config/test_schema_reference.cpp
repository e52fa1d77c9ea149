#include <catch2/catch.hpp>

#include "core/base/error.hpp"
#include "core/config/schema.hpp"
#include "core/config/schema_lookup.hpp"
#include "core/config/schema_reference.hpp"

using namespace asperity;
using Catch::Contains;
using nlohmann::ordered_json;

namespace {

/// A schema with every kind of key that a page must tell.
const ordered_json kSchema = ordered_json::parse(R"({
  "title": "Asperity tea", "description": "How tea is made.", "type": "object", "required": ["pot"],
  "properties": {
    "pot": {"description": "The pot.", "type": "object", "required": ["size_mm"], "properties": {
      "size_mm": {"description": "Height. Unit: mm.", "type": "number", "unit": "mm", "exclusiveMinimum": 0, "maximum": 300},
      "lid": {"description": "A | or <none>. Dimensionless.", "type": "integer", "unit": "1", "minimum": 0, "maximum": 1, "default": 1},
      "from": {"description": "Where from.", "type": ["object", "string"]}}},
    "cups": {"description": "The cups.", "type": "array", "x-default": "one for each", "items": {
      "description": "One cup.", "type": "object", "properties": {
        "kind": {"description": "Which.", "type": "string", "enum": ["glass", "china"], "default": "china"}}}}}})");

/// Every key of a schema without a description, list entries included.
void undescribed(const ordered_json& node, const std::string& pointer, std::vector<std::string>& found) {
  if (node.value("description", "").size() <= 5) found.push_back(pointer);
  const ordered_json keys = node.value("properties", ordered_json::object());
  for (const auto& [key, child] : keys.items()) undescribed(child, pointer + "/" + key, found);
  if (node.contains("items")) undescribed(node.at("items"), pointer + "/N", found);
}

/// Pointers of every key, list entries' keys included.
void collect(const ordered_json& node, const std::string& pointer, std::vector<std::string>& found) {
  const ordered_json keys = node.value("properties", ordered_json::object());
  for (const auto& [key, child] : keys.items()) {
    const std::string there = pointer + "/" + key;
    found.push_back(there);
    collect(child, there, found);
    if (child.contains("items")) collect(child.at("items"), there + "/N", found);
  }
}

}  // namespace

TEST_CASE("a reference page tells type, unit, range, default and meaning of every key, section by section") {
  CHECK(schema_reference(kSchema, "tea", false) ==
        "# Asperity tea: every key\n\nHow tea is made.\n\nMade by `asperity schema tea --markdown` from "
        "[configs/schema/tea.schema.json](../../configs/schema/tea.schema.json); a test holds this page equal to what "
        "the command writes. A key is named by its JSON pointer, as `--set` takes it; `N` stands for the place of a "
        "list's entry, counted from 0.\n\n"
        "| key | type | unit | allowed | default | meaning |\n|---|---|---|---|---|---|\n"
        "| `/pot` | object |  | [its keys](#pot) | **required** | The pot. |\n"
        "| `/cups` | list |  | [its entries](#cupsn) | one for each | The cups. |\n"
        "\n## `/pot`\n\nThe pot.\n\n"
        "| key | type | unit | allowed | default | meaning |\n|---|---|---|---|---|---|\n"
        "| `/pot/size_mm` | number | mm | above 0, up to 300 | **required** | Height. |\n"
        "| `/pot/lid` | whole number |  | 0 to 1 | `1` | A \\| or &lt;none>. |\n"
        "| `/pot/from` | object or text |  |  | – | Where from. |\n"
        "\n## `/cups/N`\n\nOne cup.\n\n"
        "| key | type | unit | allowed | default | meaning |\n|---|---|---|---|---|---|\n"
        "| `/cups/N/kind` | text |  | \"glass\" or \"china\" | `\"china\"` | Which. |\n");
}

TEST_CASE("a run's page says where a key has a meaning") {
  const std::string page = schema_reference("run");
  CHECK_THAT(page, Contains("| `/experiment/confining_pressure_mpa` | number | MPa | 0 to 1000 | `0.0` | Pressure on "
                            "both flanks") &&
                       Contains("the other experiments have none. *Only in a triaxial test.* |") &&
                       Contains("*Only for a Brazilian disc; only with curved jaws.* |"));
  CHECK_THAT(schema_reference("measured"), !Contains("*Only "));
}

TEST_CASE("every key of every schema, list entries included, is described and stands in its page") {
  for (const std::string& kind : schema_kinds()) {
    CAPTURE(kind);
    const ordered_json schema = ordered_json::parse(schema_text(kind));
    std::vector<std::string> without, pointers;
    undescribed(schema, "", without);
    CHECK(without == std::vector<std::string>{});
    collect(schema, "", pointers);
    CHECK(pointers.size() > 20);
    const std::string page = schema_reference(kind);
    std::vector<std::string> missing;
    for (const std::string& pointer : pointers)
      if (page.find("\n| `" + pointer + "` | ") == std::string::npos) missing.push_back(pointer);
    CHECK(missing == std::vector<std::string>{});
  }
}

TEST_CASE("an unknown kind has no page") { CHECK_THROWS_AS(schema_reference("rnu"), Error); }
