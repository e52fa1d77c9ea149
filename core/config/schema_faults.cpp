#include "core/config/schema_faults.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "core/config/schema_lookup.hpp"
#include "core/config/suggest.hpp"

namespace asperity {

using nlohmann::json;
using Finding = valijson::ValidationResults::Error;

namespace {

/// valijson repeats every error for each level above it in these words.
constexpr std::string_view kEcho = "Failed to validate ";
constexpr std::string_view kUnknownKey = "Object contains a property ";
constexpr std::string_view kMissingKey = "Missing required property '";
constexpr std::string_view kWrongType = "Value type not permitted";

/// What valijson says, and what we say.
constexpr std::array<std::pair<std::string_view, const char*>, 6> kClauses{{
    {"Expected number", "is out of range"},
    {"Failed to match against any enum", "is not one of the allowed words"},
    {"Array should contain", "has the wrong number of values"},
    {"Elements at indexes", "has a value twice"},
    {"Failed to match regex", "has a character that is not allowed here, or starts with one"},
    {"String should be", "has the wrong length"},
}};

std::string clause(const Finding& finding, const json& node) {
  if (finding.description.starts_with(kWrongType)) return "must be " + type_text(node);
  for (const auto& [theirs, ours] : kClauses)
    if (finding.description.starts_with(theirs)) return ours;
  return finding.description;
}

/// The JSON pointer of valijson's context {"<root>", "[experiment]", "[width_mm]"}.
std::string pointer_of(const Finding& finding) {
  std::string pointer;
  for (std::size_t i = 1; i < finding.context.size(); ++i)
    pointer = child_pointer(pointer, std::string_view(finding.context[i]).substr(1, finding.context[i].size() - 2));
  return pointer;
}

bool is_quoted_number(const json& value) {
  return value.is_string() && json::accept(value.get<std::string>()) &&
         json::parse(value.get<std::string>()).is_number();
}

/// The nearest of the allowed words; empty if none is near.
std::string nearest_word(const json& value, const json& node) {
  if (!value.is_string() || !node.contains("enum")) return {};
  return closest(value.get<std::string>(), node.at("enum").get<std::vector<std::string>>());
}

std::string value_hint(const json& value, const json& node) {
  const std::string word = nearest_word(value, node);
  if (!word.empty()) return "did you mean \"" + word + "\"?";
  const std::string type = single_type(node);
  if ((type == "number" || type == "integer") && is_quoted_number(value)) return "write the number without quotes";
  return node.value("description", "");
}

Fault value_fault(const Finding& finding, const json& document, const json& schema) {
  const std::string pointer = pointer_of(finding);
  const json& value = document.at(json::json_pointer(pointer));
  const json& node = *schema_at(schema, pointer);
  return {pointer, clause(finding, node), json_text(value), allowed_text(node), value_hint(value, node)};
}

Fault missing_fault(const Finding& finding, const json& schema) {
  const std::string rest = finding.description.substr(kMissingKey.size());
  const std::string pointer = child_pointer(pointer_of(finding), rest.substr(0, rest.find('\'')));
  const json& node = *schema_at(schema, pointer);
  return {pointer, "is missing", "", allowed_text(node), node.value("description", "")};
}

/// valijson names the first unknown key of an object only: we name each.
std::vector<Fault> unknown_key_faults(const Finding& finding, const json& document, const json& schema) {
  std::vector<Fault> faults;
  const std::string parent = pointer_of(finding);
  const json& node = *schema_at(schema, parent);
  for (const auto& [key, value] : document.at(json::json_pointer(parent)).items())
    if (!node.at("properties").contains(key))
      faults.push_back({child_pointer(parent, key), "is not a key of the configuration", json_text(value),
                        allowed_text(node), key_hint(schema, parent, key)});
  return faults;
}

/// Whether a finding says no more than what is named already: valijson has one for each pair of equal values.
bool is_repeated(const Finding& finding, const std::set<std::string>& named) {
  return !finding.description.starts_with(kUnknownKey) && !finding.description.starts_with(kMissingKey) &&
         named.contains(pointer_of(finding));
}

std::vector<Fault> faults_of(const Finding& finding, const json& document, const json& schema) {
  if (finding.description.starts_with(kEcho)) return {};
  if (finding.description.starts_with(kUnknownKey)) return unknown_key_faults(finding, document, schema);
  if (finding.description.starts_with(kMissingKey)) return {missing_fault(finding, schema)};
  return {value_fault(finding, document, schema)};
}

/// The schema as valijson wants it. Making it takes far longer than using it, so the last one is kept.
const valijson::Schema& prepared(const json& schema) {
  thread_local json source;
  thread_local std::unique_ptr<valijson::Schema> result;
  if (!result || source != schema) {
    result = std::make_unique<valijson::Schema>();
    valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(schema), *result);
    source = schema;
  }
  return *result;
}

/// In valijson's order, but wrong types first: they are the cause of what else is wrong with the value.
std::vector<Finding> findings(const json& document, const json& schema) {
  valijson::ValidationResults results;
  valijson::Validator().validate(prepared(schema), valijson::adapters::NlohmannJsonAdapter(document), &results);
  std::vector<Finding> ordered(results.begin(), results.end());
  std::stable_partition(ordered.begin(), ordered.end(),
                        [](const Finding& finding) { return finding.description.starts_with(kWrongType); });
  return ordered;
}

}  // namespace

std::vector<Fault> schema_faults(const json& document, const json& schema) {
  std::vector<Fault> faults;
  std::set<std::string> named;
  for (const Finding& finding : findings(document, schema)) {
    if (is_repeated(finding, named)) continue;
    for (Fault& fault : faults_of(finding, document, schema))
      if (named.insert(fault.where).second) faults.push_back(std::move(fault));
  }
  return faults;
}

}  // namespace asperity
