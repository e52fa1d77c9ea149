#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/report_parts.hpp"

namespace asperity::app {
namespace {

using html::ColumnKind;
using html::Markup;
using html::RowTone;

/// "x_1 x_2^2" of "x1x2", "x1^2": factors' numbers lowered, powers raised.
Markup term_markup(const std::string& term) {
  std::string text;
  for (const char c : term) {
    if (c == 'x')
      text += (text.empty() || text.back() == ' ' ? "" : " ") + std::string("x_{");
    else if (c == '^')
      text += "^";
    else
      text += c;
  }
  std::string closed;  // every "x_{" is closed before the next blank, power or end
  bool open = false;
  for (const char c : text) {
    if (open && (c == ' ' || c == '^')) closed += '}', open = false;
    closed += c;
    if (c == '{') open = true;
  }
  return html::formula(open ? closed + "}" : closed);
}

const std::vector<std::pair<std::string, std::string>>& measures() {
  static const std::vector<std::pair<std::string, std::string>> table{
      {"R²", "r2"}, {"R², adjusted", "r2_adjusted"}, {"R², predicted", "r2_predicted"}};
  return table;
}

Markup lack_of_fit_text(const Value& lack) {
  if (!lack["p"].exists()) return "–";
  const bool fits = lack["p"].number() >= 0.05;
  return "F = " + html::number(lack["f"].number(), 3) + ", p = " + p_value(lack["p"].number()) +
         (fits ? ": not significant" : ": significant at 5 %");
}

Markup overview(const Value& root) {
  html::Table table{
      "Quality of the models before (full) and after elimination (reduced); lack of fit is tested against the centre "
      "points' pure error.",
      {{"Response", {}, ColumnKind::head}},
      {}};
  for (const char* which : {"full", "reduced"})
    for (const auto& [name, key] : measures()) table.columns.push_back({name, which});
  table.columns.push_back({"Residual standard deviation"});
  table.columns.push_back({"Lack of fit", {}, ColumnKind::text});
  for (const auto& [property, model] : root["models"].entries()) {
    const Quantity quantity = quantity_of(property);
    html::Row row{{name_and_symbol(quantity)}};
    for (const char* prefix : {"", "reduced_"})
      for (const auto& [name, key] : measures()) row.cells.push_back(html::number(model[prefix + key].number(), 3));
    row.cells.push_back(quantity_text(model["residual_sd"].number(), quantity, 3));
    row.cells.push_back(lack_of_fit_text(model["lack_of_fit"]));
    table.rows.push_back(row);
  }
  return html::table(table);
}

std::string spelled(std::string source) {
  std::replace(source.begin(), source.end(), '_', ' ');
  return source;
}

Markup source_markup(const std::string& source) {
  return !source.empty() && source.find_first_not_of("x0123456789^") == std::string::npos ? term_markup(source)
                                                                                          : Markup(spelled(source));
}

Markup anova_table(const Value& model) {
  html::Table table{
      "Analysis of variance of the full quadratic.",
      {{"Source", {}, ColumnKind::head}, {"Degrees of freedom"}, {"Sum of squares"}, {"Mean square"}, {"F"}, {"p"}},
      {}};
  for (const Value& line : model["anova"].items())
    table.rows.push_back({{source_markup(line["source"].text()), line["df"].words(),
                           html::number(line["sum_of_squares"].number()), html::number(line["mean_square"].number()),
                           html::number(line["f"].number(), 3), p_value(line["p"].number())}});
  return table.rows.empty() ? Markup() : html::table(table);
}

html::Row coefficient_row(const std::string& term, const Value& model) {
  const bool kept = !model["reduced"].exists() || model["reduced"][term].exists();
  return {
      {term_markup(term), html::number(model["coefficients"][term].number()),
       html::number(model["standard_errors"][term].number(), 2), p_value(model["p_values"][term].number()),
       html::number(model["reduced"][term].number()), html::number(model["reduced_standard_errors"][term].number(), 2),
       p_value(model["reduced_p_values"][term].number())},
      kept ? RowTone::plain : RowTone::quiet};
}

Markup coefficient_table(const Value& model, const Quantity& quantity) {
  html::Table table{"Coefficients in coded factors, in " +
                        (quantity.unit == "–" ? std::string("the response's own unit") : quantity.unit) +
                        "; – in the reduced model: eliminated.",
                    {{"Term", {}, ColumnKind::head},
                     {"Full", "coefficient"},
                     {"Full", "standard error"},
                     {"Full", "p"},
                     {"Reduced", "coefficient"},
                     {"Reduced", "standard error"},
                     {"Reduced", "p"}},
                    {}};
  const Value terms = model[model["coefficients"].exists() ? "coefficients" : "reduced"];
  for (const auto& [term, value] : terms.entries()) table.rows.push_back(coefficient_row(term, model));
  return html::table(table);
}

Markup eliminated_text(const Value& model) {
  if (!model["eliminated"].exists()) return {};
  Markup terms;
  for (const Value& term : model["eliminated"].items()) terms += (terms.empty() ? "" : ", ") + term_markup(term.text());
  return html::paragraph(terms.empty() ? Markup("No term was eliminated.")
                                       : "Eliminated, in this order: " + terms + ".");
}

Markup residual_text(const Value& checks) {
  if (!checks.exists()) return {};
  Markup text = "Residual checks: normality p = " + p_value(checks["normality_p"].number()) +
                "; largest studentised residual " + html::number(checks["largest_studentised"].number(), 3);
  if (checks["row_of_largest"].exists()) text += " (run " + std::to_string(checks["row_of_largest"].count() + 1) + ")";
  return html::paragraph(text + "; correlation with the order of the runs " +
                         html::number(checks["run_order_correlation"].number(), 2) + ".");
}

bool has_residuals(const ModelData& model) {
  return std::any_of(model.studentised.begin(), model.studentised.end(), [](double v) { return std::isfinite(v); });
}

html::Section model_section(const ReportContext& context, const std::string& property, const Value& model) {
  const Quantity quantity = quantity_of(property);
  html::Section section{capitalised(quantity.name), {}, {}};
  for (const Markup& part : {anova_table(model), coefficient_table(model, quantity), eliminated_text(model),
                             residual_text(model["residual_checks"])})
    if (!part.empty()) section.parts.push_back(part);
  for (const ModelData& data : context.data.models)
    if (data.property == property && has_residuals(data)) section.parts.push_back(residuals_figure(context, data));
  return section;
}

}  // namespace

html::Section models_section(const ReportContext& context) {
  html::Section section{"Models and analysis of variance", {}, {}};
  const auto models = context.root["models"].entries();
  if (models.empty()) return section;
  section.parts.push_back(overview(context.root));
  for (const auto& [property, model] : models)
    if (model.exists()) section.sections.push_back(model_section(context, property, model));
  return section;
}

}  // namespace asperity::app
