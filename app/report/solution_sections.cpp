#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/report_parts.hpp"
#include "render/outcome_plots.hpp"

namespace asperity::app {
namespace {

using html::ColumnKind;
using html::Markup;

std::vector<std::string> pointers_of(const Value& parameters) {
  std::vector<std::string> pointers;
  for (const auto& [pointer, value] : parameters.entries()) pointers.push_back(pointer);
  return pointers;
}

Markup solutions_table(const ReportContext& context) {
  const std::vector<Value> solutions = context.root["solutions"].items();
  html::Table table{
      "All distinct solutions inside the design, most desirable first, with what the models predict there.",
      {{"Solution", {}, ColumnKind::head}, {"Desirability"}},
      {}};
  const std::vector<std::string> pointers = pointers_of(solutions.front()["parameters"]);
  for (const std::string& pointer : pointers)
    table.columns.push_back(quantity_column(parameter_quantity(context.data, pointer)));
  const auto predicted = solutions.front()["predicted"].entries();
  for (const auto& [property, value] : predicted) table.columns.push_back(quantity_column(quantity_of(property)));
  for (const Value& solution : solutions) {
    html::Row row{{std::to_string(table.rows.size() + 1), html::number(solution["desirability"].number(), 3)}};
    for (const std::string& pointer : pointers)
      row.cells.push_back(html::number(solution["parameters"][pointer].number()));
    for (const auto& [property, value] : predicted)
      row.cells.push_back(html::number(solution["predicted"][property]["value"].number()));
    table.rows.push_back(row);
  }
  return html::table(table);
}

html::Row route_row(const std::vector<std::string>& pointers, const std::string& name, const Value& route) {
  html::Row row{{name}};
  for (const std::string& pointer : pointers) {
    const double sd = route["sd"][pointer].number();
    row.cells.push_back(html::with_scatter(route["parameters"][pointer].number(), sd));
  }
  row.cells.push_back(route["runs"].words());
  row.cells.push_back(html::number(route["misfit"].number(), 3));
  return row;
}

Markup route_steps(const ReportContext& context, const Value& route, const std::vector<std::string>& pointers) {
  html::Table table{
      "Steps of the refinement on the kriging emulator, each on real runs.", {{"Step", {}, ColumnKind::head}}, {}};
  for (const std::string& pointer : pointers)
    table.columns.push_back(quantity_column(parameter_quantity(context.data, pointer)));
  table.columns.push_back({"Misfit", "–"});
  for (const Value& step : route["steps"].items()) {
    if (!step.is_object()) continue;
    html::Row row{{std::to_string(table.rows.size() + 1)}};
    for (const std::string& pointer : pointers) row.cells.push_back(html::number(step["parameters"][pointer].number()));
    row.cells.push_back(html::number(step["misfit"].number(), 3));
    table.rows.push_back(row);
  }
  return table.rows.empty() ? Markup() : html::table(table);
}

Markup measure_table(const std::string& test, const Value& measures) {
  html::Table table{capitalised(test) + ": measures of the failure mode.",
                    {{"Measure", {}, ColumnKind::head}, {"Value"}, {"Unit", {}, ColumnKind::text}},
                    {}};
  for (const auto& [key, value] : measures.entries()) {
    const Quantity quantity = quantity_of(key);
    table.rows.push_back(
        {{quantity.name, value.is_number() ? html::number(value.number()) : Markup(value.words()), quantity.unit}});
  }
  return html::table(table);
}

/// OUT/pictures/*.png by name.
std::vector<html::Picture> pictures_of(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "pictures", none))
    if (entry.path().extension() == ".png") files.push_back(entry.path().filename());
  std::sort(files.begin(), files.end());
  std::vector<html::Picture> pictures;
  for (const auto& file : files) {
    std::string name = file.stem().string();
    std::replace(name.begin(), name.end(), '_', ' ');
    pictures.push_back({html::linked_source(std::filesystem::path("pictures") / file),
                        "Failure pattern of the chosen parameters: " + name});
  }
  return pictures;
}

constexpr const char* kTension = "tensile_strength_mpa";
constexpr const char* kCompression = "uniaxial_strength_mpa";

/// Two properties that every set was verified for: tensile and uniaxial strength where they are there.
std::optional<std::pair<std::string, std::string>> trade_off_axes(const std::vector<Value>& sets) {
  std::vector<std::string> common;
  for (const auto& [property, first] : sets.front()["verification"].entries())
    if (std::all_of(sets.begin(), sets.end(),
                    [&, name = property](const Value& set) { return set["verification"][name]["mean"].exists(); }))
      common.push_back(property);
  const auto has = [&](const char* name) { return std::find(common.begin(), common.end(), name) != common.end(); };
  if (has(kTension) && has(kCompression)) return std::pair<std::string, std::string>{kCompression, kTension};
  if (common.size() < 2) return std::nullopt;
  return std::pair{common[0], common[1]};
}

render::Range target_range(const Value& root, const Value& verified, const std::string& property) {
  const bool own = root["targets"][property]["value"].exists();
  const double value = own ? root["targets"][property]["value"].number() : verified["target"].number();
  const double tolerance = own ? root["targets"][property]["tolerance"].number() : verified["tolerance"].number();
  const double half = std::isfinite(tolerance) ? std::abs(value) * tolerance : 0;
  return {value - half, value + half};
}

render::VerifiedSet verified_set(const Value& set, const std::string& x, const std::string& y) {
  const Value vx = set["verification"][x], vy = set["verification"][y];
  return {marked_indices(set["name"].text()),
          vx["mean"].number(),
          vy["mean"].number(),
          vx["sd"].number(),
          vy["sd"].number(),
          vx["values"].numbers(),
          vy["values"].numbers()};
}

Markup trade_off_figure(const ReportContext& context, const std::vector<Value>& sets) {
  const auto axes = trade_off_axes(sets);
  if (!axes) return {};
  const auto& [x, y] = *axes;
  const Quantity qx = quantity_of(x), qy = quantity_of(y);
  render::TradeOff given{"Trade-off of verified parameter sets",
                         "",
                         axis_label(qx),
                         axis_label(qy),
                         target_range(context.root, sets.front()["verification"][x], x),
                         target_range(context.root, sets.front()["verification"][y], y),
                         {}};
  std::string words;
  for (const Value& set : sets) {
    given.sets.push_back(verified_set(set, x, y));
    words += fmt::format("{}{} at {:.3g} and {:.3g}", words.empty() ? "" : "; ", set["name"].text(),
                         given.sets.back().x, given.sets.back().y);
  }
  const PlotText text{
      "trade_off", fmt::format("Verified parameter sets by {} and {}: {}.", qx.name, qy.name, words),
      html::Markup("Verified parameter sets by " + qx.name + " and " + qy.name +
                   ": mean ± one standard deviation and single meshes; in the green box both targets are met.")};
  return plot_figure(context, text, render::trade_off(given));
}

Markup trade_off_table(const std::vector<Value>& sets) {
  html::Table table{
      "Verified parameter sets: mean ± standard deviation on fresh meshes, and deviation from the target; * within "
      "tolerance.",
      {{"Set", {}, ColumnKind::head}, {"Why", {}, ColumnKind::text}},
      {}};
  const auto properties = sets.front()["verification"].entries();
  for (const auto& [property, v] : properties) table.columns.push_back(quantity_column(quantity_of(property)));
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const std::string letter(1, static_cast<char>('A' + i % 26));
    html::Row row{{html::strong(letter) + " " + page_text(sets[i]["name"].text()), page_text(sets[i]["why"].text())}};
    for (const auto& [property, first] : properties) {
      const Value v = sets[i]["verification"][property];
      const double mean = v["mean"].number(), target = v["target"].number();
      row.cells.push_back(html::lines({html::with_scatter(mean, v["sd"].number()),
                                       percent(mean / target - 1) + (v["within"].truth() ? " *" : "")}));
    }
    table.rows.push_back(row);
  }
  return html::table(table);
}

}  // namespace

html::Section desirability_section(const ReportContext& context) {
  html::Section section{"Desirability and solutions", desirability_figures(context), {}};
  const Value solutions = context.root["solutions"];
  if (!solutions.items().empty())
    section.parts.insert(section.parts.begin(), solutions_table(context));
  else if (solutions.exists())
    section.parts.insert(
        section.parts.begin(),
        html::notice(html::NoticeKind::information, "No point of the design meets all targets by the models."));
  return section;
}

html::Section routes_section(const ReportContext& context) {
  html::Section section{"The two routes", {}, {}};
  const Value routes = context.root["routes"];
  if (routes.entries().empty()) return section;
  std::vector<std::string> pointers = pointers_of(routes["quadratic"]["parameters"]);
  if (pointers.empty()) pointers = pointers_of(routes["kriging"]["parameters"]);
  html::Table table{
      "Response surfaces against a kriging emulator that is refined on real runs: parameters (± standard deviation), "
      "cost and what is left of the misfit.",
      {{"Route", {}, ColumnKind::head}},
      {}};
  for (const std::string& pointer : pointers)
    table.columns.push_back(quantity_column(parameter_quantity(context.data, pointer)));
  table.columns.push_back({"Runs"});
  table.columns.push_back({"Misfit", "–"});
  for (const auto& [name, route] : routes.entries())
    if (route.exists()) table.rows.push_back(route_row(pointers, name, route));
  section.parts.push_back(html::table(table));
  const Markup steps = route_steps(context, routes["kriging"], pointers);
  if (!steps.empty()) section.parts.push_back(steps);
  return section;
}

html::Section failure_section(const ReportContext& context) {
  html::Section section{"Failure mode", {}, {}};
  for (const auto& [test, measures] : context.root["failure_mode"].entries())
    if (!measures.entries().empty()) section.parts.push_back(measure_table(test, measures));
  const std::vector<html::Picture> pictures = pictures_of(context.folder);
  if (!pictures.empty())
    section.parts.push_back(html::figure({pictures, "Crack networks of the chosen parameters.", {}}));
  return section;
}

html::Section trade_off_section(const ReportContext& context) {
  html::Section section{"Trade-off", {}, {}};
  const std::vector<Value> sets = context.root["trade_off"].items();
  if (sets.empty()) return section;
  section.parts.push_back(html::paragraph(
      "Where the targets exclude one another, these sets show by verified runs what each choice costs."));
  const Markup figure = trade_off_figure(context, sets);
  if (!figure.empty()) section.parts.push_back(figure);
  section.parts.push_back(trade_off_table(sets));
  return section;
}

}  // namespace asperity::app
