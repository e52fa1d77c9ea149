#include <limits>

#include "core/config/enum_words.hpp"
#include "core/config/mechanism_declaration.hpp"
#include "core/config/schema_lookup.hpp"

namespace asperity {

using nlohmann::ordered_json;

namespace {

std::string with_stop(std::string text) {
  if (!text.empty() && text.back() != '.') text += '.';
  return text;
}

/// Two mechanisms may have a parameter of one name: the node then allows what either does.
void add_parameter(ordered_json& properties, const MechanismDeclaration& m, const MechanismParameter& p) {
  ordered_json& node = properties[p.key];
  const std::string text = "Of " + m.id + ": " + with_stop(p.description) + " Strong: " + number_text(p.strong) + ".";
  if (node.is_null()) {
    node = {{"description", ""},   {"type", "number"},    {"unit", p.unit}, {"x-default", "follows from the amplitude"},
            {"minimum", p.lowest}, {"maximum", p.highest}};
  }
  const std::string so_far = node["description"];
  node["description"] = so_far.empty() ? text : so_far + " " + text;
  node["minimum"] = std::min(node["minimum"].get<double>(), p.lowest);
  node["maximum"] = std::max(node["maximum"].get<double>(), p.highest);
}

void end_with_units(ordered_json& properties) {
  for (auto& [key, node] : properties.items()) {
    if (!node.contains("unit") || node["unit"] == "1") continue;
    node["description"] = node["description"].get<std::string>() + " Unit: " + node["unit"].get<std::string>() + ".";
  }
}

ordered_json type_node(const std::vector<MechanismDeclaration>& all) {
  ordered_json ids = ordered_json::array();
  std::string titles;
  for (const MechanismDeclaration& m : all) {
    ids.push_back(m.id);
    titles += (titles.empty() ? "" : "; ") + m.id + ": " + m.title;
  }
  return {{"description", "Which mechanism of the library. " + titles + "."}, {"type", "string"}, {"enum", ids}};
}

}  // namespace

ordered_json mechanisms_schema() {
  const std::vector<MechanismDeclaration> all = declared_mechanisms();
  ordered_json properties = {{"type", type_node(all)},
                             {"amplitude",
                              {{"description",
                                "0: the base model; 1: the declared strong values, which hold where "
                                "neither it nor a parameter is given."},
                               {"type", "number"},
                               {"unit", "1"},
                               {"default", 1.0},
                               {"minimum", 0.0},
                               {"maximum", 5.0}}}};
  for (const MechanismDeclaration& m : all)
    for (const MechanismParameter& p : m.parameters) add_parameter(properties, m, p);
  end_with_units(properties);
  return {{"description", "Mechanisms that are added to the base model, each once; docs/mechanisms.md tells of each."},
          {"type", "array"},
          {"x-default", "none"},
          {"items",
           {{"description", "One mechanism."},
            {"type", "object"},
            {"additionalProperties", false},
            {"required", {"type"}},
            {"properties", properties}}}};
}

}  // namespace asperity
