#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/report_parts.hpp"

namespace asperity::app {
namespace {

using html::ColumnKind;
using html::Markup;
using html::RowTone;

Markup factor_table(const CalibrationData& data) {
  html::Table table{
      "Factors of the design: real value = centre + step × coded level (logarithmic scale: centre × step to the power "
      "of it).",
      {{"Factor", {}, ColumnKind::head},
       {"Microparameter", {}, ColumnKind::text},
       {"Pointer", {}, ColumnKind::text},
       {"Centre"},
       {"Step"},
       {"Scale", {}, ColumnKind::text}},
      {}};
  for (const FactorData& f : data.factors)
    table.rows.push_back(
        {{f.name, name_and_symbol(f.quantity), html::code(f.pointer), with_unit(html::as_given(f.centre), f.quantity),
          f.logarithmic ? "× " + html::as_given(f.step) : with_unit(html::as_given(f.step), f.quantity),
          f.logarithmic ? "logarithmic" : "linear"}});
  return html::table(table);
}

/// What is said of bad runs, row by row of the design, from 0.
std::vector<std::string> bad_rows(const Value& root, std::size_t rows) {
  std::vector<std::string> tests(rows);
  for (const Value& bad : root["bad_runs"].items()) {
    const int row = bad["row"].count();
    if (row < 0 || static_cast<std::size_t>(row) >= rows || !bad["row"].exists()) continue;
    std::string& text = tests[static_cast<std::size_t>(row)];
    text += (text.empty() ? "" : ", ") + (bad["test"].exists() ? bad["test"].words() : "run");
  }
  return tests;
}

std::vector<html::Column> run_columns(const ReportContext& context) {
  std::vector<html::Column> columns{{"Run", {}, ColumnKind::head}, {"Kind", {}, ColumnKind::text}};
  for (const FactorData& f : context.data.factors) columns.push_back({f.name, "coded"});
  for (const FactorData& f : context.data.factors) columns.push_back(quantity_column(f.quantity));
  if (context.root["design"]["seeds"].exists()) columns.push_back({"Seed"});
  for (const auto& [key, values] : context.root["responses"].entries())
    columns.push_back(quantity_column(quantity_of(key)));
  columns.push_back({"Bad", {}, ColumnKind::text});
  return columns;
}

Markup at(const std::vector<double>& values, std::size_t i, int digits) {
  return html::number(i < values.size() ? values[i] : NAN, digits);
}

/// The lists of the design and of the responses, each one entry a run.
struct RunLists {
  std::vector<Value> real, kinds, seeds;
  std::vector<std::vector<double>> responses;
  std::vector<std::string> bad;
};

RunLists run_lists(const ReportContext& context) {
  const Value design = context.root["design"];
  RunLists lists{design["real"].items(),
                 design["kind"].items(),
                 design["seeds"].items(),
                 {},
                 bad_rows(context.root, context.data.coded.size())};
  for (const auto& [key, values] : context.root["responses"].entries()) lists.responses.push_back(values.numbers());
  return lists;
}

html::Row run_row(const ReportContext& context, const RunLists& lists, std::size_t i) {
  const CalibrationData& data = context.data;
  html::Row row{{std::to_string(i + 1), i < lists.kinds.size() ? lists.kinds[i].text() : ""}};
  for (const double level : data.coded[i]) row.cells.push_back(html::as_given(level));
  const std::vector<double> real = i < lists.real.size() ? lists.real[i].numbers() : std::vector<double>();
  for (std::size_t k = 0; k < data.factors.size(); ++k)
    row.cells.push_back(html::number(k < real.size() ? real[k] : data.factors[k].real(data.coded[i][k]), 3));
  if (context.root["design"]["seeds"].exists())
    row.cells.emplace_back(i < lists.seeds.size() ? lists.seeds[i].words() : "–");
  for (const std::vector<double>& values : lists.responses) row.cells.push_back(at(values, i, 3));
  row.cells.emplace_back(lists.bad[i]);
  if (!lists.bad[i].empty()) row.tone = RowTone::bad;
  return row;
}

Markup run_table(const ReportContext& context) {
  html::Table table{
      "The design, coded and real, with the responses of each run; – where a run gave none.", run_columns(context), {}};
  const RunLists lists = run_lists(context);
  for (std::size_t i = 0; i < context.data.coded.size(); ++i) table.rows.push_back(run_row(context, lists, i));
  return html::table(table);
}

Markup bad_run_table(const Value& root) {
  html::Table table{"Bad runs, and how the analysis treats them.",
                    {{"Run", {}, ColumnKind::head},
                     {"Test", {}, ColumnKind::text},
                     {"Reason", {}, ColumnKind::text},
                     {"Treatment", {}, ColumnKind::text}},
                    {}};
  for (const Value& bad : root["bad_runs"].items())
    table.rows.push_back({{bad["row"].exists() ? std::to_string(bad["row"].count() + 1) : "–", bad["test"].words(),
                           page_text(bad["reason"].words()), page_text(bad["treatment"].words())},
                          RowTone::bad});
  return html::table(table);
}

/// One value a factor, given by pointer, by name or in the factors' order.
double factor_value(const Value& values, const FactorData& factor, std::size_t k) {
  if (values.is_list()) {
    const std::vector<double> list = values.numbers();
    return k < list.size() ? list[k] : NAN;
  }
  if (!values.is_object()) return NAN;
  const Value by_pointer = values[factor.pointer];
  return by_pointer.exists() ? by_pointer.number() : values[factor.name].number();
}

Markup factor_values(const CalibrationData& data, const Value& values) {
  if (!values.is_list() && !values.is_object()) return values.words();
  Markup text;
  for (std::size_t k = 0; k < data.factors.size(); ++k)
    text += (k ? ", " : "") + html::number(factor_value(values, data.factors[k], k), 3);
  return text;
}

Markup solution_count(const Value& solutions) {
  return solutions.is_list() ? std::to_string(solutions.items().size()) : solutions.words();
}

}  // namespace

html::Section design_section(const ReportContext& context) {
  html::Section section{"Design and runs", {}, {}};
  if (context.data.factors.empty()) return section;
  section.parts.push_back(factor_table(context.data));
  const double alpha = context.root["design"]["alpha"].number();
  if (std::isfinite(alpha))
    section.parts.push_back(
        html::paragraph("Star points at a coded distance α = " + html::number(alpha) + " from the centre."));
  if (!context.data.coded.empty()) section.parts.push_back(run_table(context));
  if (!context.root["bad_runs"].items().empty())
    section.parts.push_back(bad_run_table(context.root));
  else if (context.root["bad_runs"].exists())
    section.parts.push_back(html::paragraph("No run was bad."));
  return section;
}

html::Section rounds_section(const ReportContext& context) {
  html::Section section{"Rounds of the moving design", {}, {}};
  std::string names;
  for (const FactorData& f : context.data.factors)
    names += (names.empty() ? "" : ", ") + (f.quantity.symbol.empty() ? f.name : f.quantity.symbol);
  const Markup order = page_text(names);
  html::Table table{
      "Where a target lies outside the design, the design moves along the steepest ascent of the desirability. Values "
      "in the "
      "order of the factors: " +
          order + ".",
      {{"Round", {}, ColumnKind::head}, {"Centre"}, {"Step"}, {"Moved by"}, {"Best desirability"}, {"Solutions"}},
      {}};
  for (const Value& round : context.root["rounds"].items())
    table.rows.push_back({{std::to_string(table.rows.size() + 1), factor_values(context.data, round["centre"]),
                           factor_values(context.data, round["step"]), factor_values(context.data, round["moved_by"]),
                           html::number(round["best_desirability"].number(), 3), solution_count(round["solutions"])}});
  if (!table.rows.empty()) section.parts.push_back(html::table(table));
  return section;
}

}  // namespace asperity::app
