#include <fmt/format.h>

#include <cmath>

#include "app/report/report_parts.hpp"

namespace asperity::app {
namespace {

using html::ColumnKind;
using html::formula;
using html::Markup;

std::string duration(double seconds) {
  if (!std::isfinite(seconds)) return "–";
  return seconds < 120 ? fmt::format("{:.1f} s", seconds) : fmt::format("{:.1f} min ({:.0f} s)", seconds / 60, seconds);
}

std::vector<html::Definition> scatter_definitions() {
  return {{"Mean", formula("m = (y_1 + … + y_n) / n") + " over the n fresh meshes of one parameter set."},
          {"Standard deviation",
           formula("s = [ ((y_1 − m)^2 + … + (y_n − m)^2) / (n − 1) ]^{1/2}") + ": of single meshes, not of the mean."},
          {"Bias", formula("b = m / T − 1") + " with the target T. Within tolerance τ: " + formula("|b| ≤ τ") + "."},
          {"Predicted",
           "Value of the reduced model at the chosen parameters; obtained: mean of real runs on meshes that no fit has "
           "seen."}};
}

std::vector<html::Definition> model_definitions() {
  return {
      {"Model", formula("y = β_0 + Σ β_i x_i + Σ β_{ij} x_i x_j + Σ β_{ii} x_i^2 + ε") +
                    " in coded factors; reduced: without the terms that backward elimination took out."},
      {"R², adjusted and predicted",
       formula("R^2 = 1 − S_E / S_T") + ", " + formula("R^2_{adj} = 1 − (S_E / (n − p)) / (S_T / (n − 1))") + ", " +
           formula("R^2_{pred} = 1 − Σ (e_i / (1 − h_i))^2 / S_T") +
           " with the sums of squares of residuals and in total, n runs, p terms, residuals e and leverages h."},
      {"Lack of fit", formula("F = (S_{LOF} / f_{LOF}) / (S_{PE} / f_{PE})") +
                          ": what the model leaves over what meshes alone scatter at the centre."},
      {"Studentised residual", formula("r_i = e_i / (s (1 − h_i)^{1/2})") + " with the residual standard deviation s."},
      {"95 % band of a main effect",
       formula("ŷ ± t_{0.975} s (x (X'X)^{−1} x')^{1/2}") + ": of the mean response; single runs scatter more."}};
}

Markup shape_text(const DesirabilityShape& shape) {
  return formula("d_i = (1 − |y_i − T_i| / (h |T_i|))^q") +
         " where the bracket is positive, else 0, with h = " + html::number(shape.half_range, 3) +
         " and q = " + html::number(shape.exponent, 2);
}

/// Keys of a manifest one reads first; the rest is in the file.
Markup provenance_table(const Value& manifest) {
  html::Table table{"", {{"", {}, ColumnKind::head}, {"", {}, ColumnKind::text}}, {}};
  for (const auto& [key, value] : manifest.entries()) {
    if (!value.exists() || value.words().empty()) continue;
    table.rows.push_back({{quantity_of(key).name, value.words()}});
  }
  table.columns[0].heading = "Item";
  table.columns[1].heading = "Value";
  return html::table(table);
}

}  // namespace

html::Section cost_section(const ReportContext& context) {
  html::Section section{"Cost", {}, {}};
  const Value cost = context.root["cost"];
  if (!cost.exists()) return section;
  html::Table table{"Runs and time of the whole calibration.", {{"Cost", {}, ColumnKind::head}, {"Value"}}, {}};
  for (const auto& [key, name] : {std::pair{"runs", "runs made"}, std::pair{"reused", "finished runs used again"}})
    if (cost[key].exists()) table.rows.push_back({{name, cost[key].words()}});
  for (const auto& [key, name] :
       {std::pair{"wall_s", "time from start to end"}, std::pair{"compute_s", "computing time of all runs"}})
    if (cost[key].exists()) table.rows.push_back({{name, duration(cost[key].number())}});
  if (!table.rows.empty()) section.parts.push_back(html::table(table));
  return section;
}

html::Section definitions_section(const ReportContext& context) {
  std::vector<html::Definition> entries = scatter_definitions();
  for (const html::Definition& entry : model_definitions()) entries.push_back(entry);
  entries.push_back({"Desirability", "Of one property, target-is-best (Derringer and Suich 1980): " +
                                         shape_text(context.data.desirability) + ". Overall: " +
                                         formula("D = (Π d_i^{w_i})^{1 / Σ w_i}") + " with the targets' weights w."});
  return {"Definitions", {html::definition_list(entries)}, {}};
}

html::Section provenance_section(const ReportContext& context) {
  html::Section section{"Provenance", {}, {}};
  const std::filesystem::path file = context.folder / "manifest.json";
  if (std::filesystem::exists(file)) {
    const Document manifest(file);
    section.parts.push_back(provenance_table(manifest.root()));
    section.parts.push_back(
        html::paragraph("In full: " + html::link("manifest.json", html::code("manifest.json")) + "."));
  }
  section.parts.push_back(html::paragraph(
      "Every number of this page: " + html::link("calibration.json", html::code("calibration.json")) + "."));
  return section;
}

}  // namespace asperity::app
