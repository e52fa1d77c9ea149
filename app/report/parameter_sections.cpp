#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/report_parts.hpp"

namespace asperity::app {
namespace {

using html::ColumnKind;
using html::Markup;
using html::RowTone;

Markup interval(double low, double high, const Quantity& quantity) {
  if (!std::isfinite(low) || !std::isfinite(high)) return "–";
  return quantity_text(low, {quantity.name, quantity.symbol, "–"}) + " to " + quantity_text(high, quantity);
}

html::Row calibrated_row(const CalibrationData& data, const std::string& pointer, const Value& solution) {
  const Quantity quantity = parameter_quantity(data, pointer);
  const Value region = solution["region"], determined = region["determined"][pointer];
  Markup told = "–";
  RowTone tone = RowTone::plain;
  if (determined.exists()) {
    told = determined.truth() ? "yes" : "no: its interval reaches beyond the design";
    tone = determined.truth() ? RowTone::good : RowTone::bad;
  }
  return {{name_and_symbol(quantity), html::code(pointer),
           quantity_text(solution["parameters"][pointer].number(), quantity),
           interval(region["lower"][pointer].number(), region["upper"][pointer].number(), quantity), told},
          tone};
}

Markup calibrated_table(const ReportContext& context, const Value& solution) {
  const double level = solution["region"]["level"].number();
  const std::string share = std::isfinite(level) ? fmt::format("{:.0f} %", 100 * level) : "Confidence";
  html::Table table{
      "The calibrated parameters: value, region from the fits' covariance and the scatter of meshes, and whether "
      "the data determine each.",
      {{"Parameter", {}, ColumnKind::head},
       {"Pointer", {}, ColumnKind::text},
       {"Value"},
       {share + " region"},
       {"Determined by the data", {}, ColumnKind::text}},
      {}};
  for (const auto& [pointer, value] : solution["parameters"].entries())
    table.rows.push_back(calibrated_row(context.data, pointer, solution));
  return html::table(table);
}

Markup parameters_in_force(const ReportContext& context) {
  html::Table table{"All microparameters in force in the ready configurations.",
                    {{"Parameter", {}, ColumnKind::head}, {"Pointer", {}, ColumnKind::text}, {"Value"}},
                    {}};
  for (const auto& [pointer, value] : context.root["parameters"].entries()) {
    const Quantity quantity = parameter_quantity(context.data, pointer);
    table.rows.push_back({{name_and_symbol(quantity), html::code(pointer),
                           value.is_number() ? quantity_text(value.number(), quantity) : Markup(value.words())}});
  }
  return html::table(table);
}

std::string spelled(std::string word) {
  std::replace(word.begin(), word.end(), '_', ' ');
  return word;
}

const std::vector<const char*>& elastic_keys() {
  static const std::vector<const char*> keys{"particle_youngs_modulus_gpa", "particle_poissons_ratio",
                                             "stiffness_ratio", "youngs_modulus_gpa", "poissons_ratio"};
  return keys;
}

std::vector<html::Column> elastic_columns(const char* first) {
  return {{first, {}, ColumnKind::head},
          {page_text("E_p"), "GPa"},
          {page_text("ν_p"), "–"},
          {page_text("k_s/k_t"), "–"},
          {"E", "GPa"},
          {"ν", "–"}};
}

html::Row elastic_row(const Markup& name, const Value& figures, const Value& assembly) {
  html::Row row{{name}};
  for (const char* key : elastic_keys()) {
    const double own = figures[key].number();
    row.cells.push_back(html::number(std::isfinite(own) ? own : assembly[key].number()));
  }
  return row;
}

Markup alternatives_table(const Value& root) {
  const Value elastic = root["elastic"], nothing = root["nothing"];
  html::Table table{
      "The particles' elasticity in use, and what other rules give: E and ν are those of the assembly at its edge "
      "size.",
      elastic_columns("Rule"),
      {}};
  table.columns.push_back({"Targets reached", {}, ColumnKind::text});
  html::Row target{{"target", "", "", "", html::number(root["targets"]["youngs_modulus_gpa"]["value"].number()),
                    html::number(root["targets"]["poissons_ratio"]["value"].number()), ""},
                   RowTone::quiet};
  html::Row used =
      elastic_row(html::strong("in use") + (elastic["rule"].exists() ? ": " + spelled(elastic["rule"].words()) : ""),
                  elastic, elastic["assembly"]);
  used.cells.emplace_back("");
  table.rows = {target, used};
  for (const Value& other : elastic["alternatives"].items()) {
    html::Row row = elastic_row(page_text(other["name"].text()), other, other["assembly"]);
    row.cells.emplace_back(other["reached"].words());
    if (other["reached"].exists()) row.tone = other["reached"].truth() ? RowTone::good : RowTone::bad;
    table.rows.push_back(row);
  }
  return html::table(table);
}

Markup stiffness_table(const Value& elastic) {
  html::Table table{"Contact stiffness in use, by state of the plane.",
                    {{"Stiffness", {}, ColumnKind::head}, {"Plane stress", "MPa/mm"}, {"Plane strain", "MPa/mm"}},
                    {}};
  for (const auto& [key, name] : {std::pair{"tensile_stiffness_mpa_per_mm", "normal stiffness k_t"},
                                  std::pair{"shear_stiffness_mpa_per_mm", "shear stiffness k_s"}})
    if (elastic[key].exists())
      table.rows.push_back({{page_text(name), html::number(elastic[key]["stress"].number()),
                             html::number(elastic[key]["strain"].number())}});
  return table.rows.empty() ? Markup() : html::table(table);
}

Markup steps_table(const Value& elastic) {
  html::Table table{
      "Steps of the search: particles' elasticity tried, and what the assembly then had.", elastic_columns("Step"), {}};
  int number = 0;
  for (const Value& step : elastic["steps"].items())
    table.rows.push_back(elastic_row(std::to_string(++number), step, elastic["nothing"]));
  return table.rows.empty() ? Markup() : html::table(table);
}

}  // namespace

html::Section parameters_section(const ReportContext& context) {
  html::Section section{"Parameters", {}, {}};
  const std::vector<Value> solutions = context.root["solutions"].items();
  if (!solutions.empty()) section.parts.push_back(calibrated_table(context, solutions.front()));
  if (!context.root["parameters"].entries().empty()) section.parts.push_back(parameters_in_force(context));
  return section;
}

html::Section elastic_section(const ReportContext& context) {
  html::Section section{"Elastic compensation", {}, {}};
  const Value elastic = context.root["elastic"];
  if (!elastic.exists()) return section;
  section.parts = {
      html::paragraph("The contacts' compliance is in series with the particles', so the particles are made stiffer "
                      "until the assembly has the target's elasticity."),
      alternatives_table(context.root)};
  for (const Markup& part : {stiffness_table(elastic), steps_table(elastic)})
    if (!part.empty()) section.parts.push_back(part);
  return section;
}

}  // namespace asperity::app
