#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/report_parts.hpp"
#include "render/outcome_plots.hpp"
#include "render/text_runs.hpp"

namespace asperity::app {
namespace {

using html::ColumnKind;
using html::Markup;
using html::RowTone;

double or_else(double value, double other) { return std::isfinite(value) ? value : other; }

Markup mean_and_sd(const Value& verified, const Quantity& quantity) {
  const double mean = verified["mean"].number();
  if (!std::isfinite(mean)) return "–";
  return with_unit(html::with_scatter(mean, verified["sd"].number()), quantity);
}

/// Whether a verified mean is within its tolerance; nothing where it was not verified.
struct Verdict {
  Markup text;
  RowTone tone;
};

Verdict verdict(const Value& verified) {
  if (!verified["within"].exists()) return {"not verified", RowTone::quiet};
  return verified["within"].truth() ? Verdict{"yes", RowTone::good} : Verdict{"no", RowTone::bad};
}

html::Row outcome_row(const std::string& property, const Value& target, const Value& verified, const Value& predicted) {
  const Quantity quantity = quantity_of(property);
  const double tolerance = or_else(target["tolerance"].number(), verified["tolerance"].number());
  const double aim = or_else(target["value"].number(), verified["target"].number());
  const double foreseen = or_else(verified["predicted"].number(), predicted[property]["value"].number());
  const Verdict judged = verdict(verified);
  return {{name_and_symbol(quantity), with_unit(html::as_given(aim), quantity),
           std::isfinite(tolerance) ? fmt::format("± {:.3g} %", 100 * tolerance) : Markup("–"),
           quantity_text(foreseen, quantity), mean_and_sd(verified, quantity),
           verified["n"].exists() ? Markup(std::to_string(verified["n"].count())) : Markup("–"),
           percent(verified["bias"].number()), judged.text},
          judged.tone};
}

Markup outcome_table(const Value& root) {
  html::Table table{
      "Targets, what the response surfaces predict for the chosen parameters, and what runs on fresh meshes gave "
      "(mean ± standard deviation of n meshes).",
      {{"Property", {}, ColumnKind::head},
       {"Target"},
       {"Tolerance"},
       {"Predicted"},
       {"Obtained"},
       {"n"},
       {"Bias"},
       {"Within tolerance", {}, ColumnKind::text}},
      {}};
  const std::vector<Value> solutions = root["solutions"].items();
  const Value predicted = solutions.empty() ? root["nothing"] : solutions.front()["predicted"];
  for (const auto& [property, target] : root["targets"].entries())
    table.rows.push_back(outcome_row(property, target, root["verification"][property], predicted));
  for (const auto& [property, verified] : root["verification"].entries())
    if (!root["targets"][property].exists())
      table.rows.push_back(outcome_row(property, root["targets"][property], verified, predicted));
  return html::table(table);
}

/// The symbol and every word of the name, a line each: six properties stand side by side.
std::string in_lines(const Quantity& quantity) {
  std::string name = capitalised(quantity.name);
  std::replace(name.begin(), name.end(), ' ', '\n');
  return quantity.symbol.empty() ? name : picture_symbol(quantity) + "\n" + name;
}

std::vector<render::VerifiedProperty> verified_properties(const Value& root) {
  std::vector<render::VerifiedProperty> properties;
  for (const auto& [property, v] : root["verification"].entries()) {
    const double target = v["target"].number(), mean = v["mean"].number();
    if (!std::isfinite(target) || target == 0 || !std::isfinite(mean)) continue;
    render::VerifiedProperty p{in_lines(quantity_of(property)),
                               target,
                               mean,
                               or_else(v["sd"].number(), 0),
                               or_else(v["tolerance"].number(), 0),
                               {},
                               v["values"].numbers()};
    if (v["predicted"].exists()) p.predicted = v["predicted"].number();
    properties.push_back(std::move(p));
  }
  return properties;
}

std::string in_words(const std::vector<render::VerifiedProperty>& properties) {
  std::string text;
  for (const render::VerifiedProperty& p : properties) {
    std::string name = p.name;
    std::replace(name.begin(), name.end(), '\n', ' ');
    text +=
        fmt::format("{}{} {:+.1f} %", text.empty() ? "" : ", ", render::unmarked(name), 100 * (p.mean / p.target - 1));
  }
  return text;
}

Markup config_links(const ReportContext& context) {
  std::vector<Markup> links;
  for (const Value& config : context.root["configs"].items())
    links.push_back(html::link(config.text(), html::code(config.text())));
  return html::paragraph("Ready run configurations with these parameters:") + html::bullet_list(links);
}

}  // namespace

std::vector<Markup> warnings(const ReportContext& context) {
  std::vector<Markup> notices;
  for (const Value& warning : context.root["warnings"].items())
    notices.push_back(html::notice(html::NoticeKind::warning, page_text(warning.words())));
  return notices;
}

html::Section outcome_section(const ReportContext& context) {
  const Value& root = context.root;
  html::Section section{"Outcome", {}, {}};
  if (!root["targets"].entries().empty() || !root["verification"].entries().empty())
    section.parts.push_back(outcome_table(root));
  const auto properties = verified_properties(root);
  if (!properties.empty()) {
    const PlotText text{
        "verification", "Deviation of each verified property from its target: " + in_words(properties) + ".",
        "Runs on fresh meshes over the targets: mean ± one standard deviation, single meshes, and what the "
        "response surfaces had predicted; green: the tolerance."};
    section.parts.push_back(
        plot_figure(context, text, render::verification_bars("Verification on fresh meshes", properties)));
  } else {
    section.parts.push_back(html::notice(html::NoticeKind::information,
                                         root["kind"].text() == "data"
                                             ? "The runs are given data: nothing was simulated, so nothing is verified."
                                             : "No parameter set was verified on fresh meshes."));
  }
  if (std::filesystem::exists(context.folder / "audit.md"))
    section.parts.push_back(html::paragraph("What these data say of their source, figure by figure: " +
                                            html::link("audit.md", html::code("audit.md")) + "."));
  if (!root["configs"].items().empty()) section.parts.push_back(config_links(context));
  return section;
}

}  // namespace asperity::app
