#include <cmath>

#include "app/report/quantities.hpp"
#include "app/report/run_parts.hpp"

namespace asperity::app {
namespace {

/// Counts that stand among the results already.
bool among_results(const std::string& key) { return key == "tension" || key == "shear" || key == "fragments"; }

html::Markup value_markup(const Value& value) {
  if (!value.is_number()) return value.words();
  const double number = value.number();
  return std::floor(number) == number ? html::fixed(number, 0) : html::number(number);
}

html::Table crack_table(const Value& cracks) {
  html::Table table{
      "What the cracks tell at the end; “–” was not reached. Order parameters: 1 along the loading axis, 0 no "
      "preference, −1 across it. The b-value needs 50 events above the completeness.",
      {{"Quantity", {}, html::ColumnKind::head}, {"Value"}, {"Unit", {}, html::ColumnKind::text}},
      {}};
  for (const auto& [key, value] : cracks.entries()) {
    if (among_results(key)) continue;
    const Quantity quantity = quantity_of(key);
    table.rows.push_back({{quantity.name, value_markup(value), quantity.unit}});
  }
  return table;
}

}  // namespace

html::Section crack_section(const RunContext& context) {
  html::Section section{"Cracks", {}, {}};
  const auto add = [&](const char* name, const char* alternative, const char* caption) {
    if (const auto figure = run_figure(context, name, alternative, caption)) section.parts.push_back(*figure);
  };
  add("crack_rose", "Two roses, of the cracks in tension and in shear: crack length by direction.",
      "Directions of the cracks by mode; areas of the sectors are shares of the mode's length.");
  add("volumetric_strain",
      "Above, the stress over axial and lateral strain; below, volumetric and crack volumetric strain over the axial "
      "strain.",
      "Crack initiation and crack damage by the volumetric strain, after Martin & Chandler (1994).");
  add("fragment_sizes", "Share of the area in fragments no larger than a size, over the size.",
      "Sizes of the fragments at the end.");
  if (section.parts.empty()) return section;  // nothing broke, or nothing was drawn
  if (const Value cracks = context.summary["cracks"]; cracks.exists())
    section.parts.push_back(html::table(crack_table(cracks)));
  return section;
}

}  // namespace asperity::app
