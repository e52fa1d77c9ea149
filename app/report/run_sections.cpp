#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/mechanism_words.hpp"
#include "app/report/quantities.hpp"
#include "app/report/run_parts.hpp"

namespace asperity::app {
namespace {

using html::ColumnKind;
using html::Markup;

/// A count as it stands, another number in four digits, yes or no, words; "–" where it was not reached.
Markup value_markup(const Value& value) {
  if (!value.is_number()) return value.words();
  const double number = value.number();
  return std::floor(number) == number && std::abs(number) < 1e9 ? html::fixed(number, 0) : html::number(number);
}

html::Table quantity_table(const Markup& caption) {
  return {caption, {{"Quantity", {}, ColumnKind::head}, {"Value"}, {"Unit", {}, ColumnKind::text}}, {}};
}

html::Row quantity_row(const std::string& key, const Value& value) {
  const Quantity quantity = quantity_of(key);
  return {{name_and_symbol(quantity), value_markup(value), quantity.unit}};
}

/// The energies that the external work went to, in the order of the account.
std::vector<std::string> energy_keys() {
  return {"elastic_n_mm", "recoverable_contacts_n_mm", "fracture_n_mm", "friction_n_mm", "damping_n_mm",
          "kinetic_n_mm"};
}

std::string energy_name(const std::string& key) {
  if (key == "elastic_n_mm") return "elastic, in the particles";
  if (key == "recoverable_contacts_n_mm") return "recoverable, in contacts";
  return quantity_of(key).name;
}

Markup energy_table(const Value& energy) {
  html::Table table{
      "Where the external work went at the end. Each term comes from its own formula; what is open is told, "
      "not spread.",
      {{"Energy", {}, ColumnKind::head}, {"Amount", "N mm"}, {"Share of the work", "%"}},
      {}};
  const double work = energy["external_work_n_mm"].number();
  const auto add = [&](const std::string& name, double amount) {
    table.rows.push_back({{name, html::number(amount), html::fixed(100 * amount / work, 2)}});
  };
  for (const std::string& key : energy_keys()) add(energy_name(key), energy[key].number());
  const Value plasticity = energy["plasticity_n_mm"];  // runs from before particles could yield have none
  if (plasticity.exists() && plasticity.number() != 0.0) add("plastic strain of the particles", plasticity.number());
  add("external work", work);
  return html::table(table);
}

Markup closure_sentence(const Value& energy) {
  return Markup("The account is open by ") + html::number(energy["relative_closure_error"].number(), 2) +
         " of the external work. Kinetic energy was at most " +
         html::number(energy["kinetic_over_stored_before_peak"].number(), 2) +
         " of the stored energy between a tenth of the peak and the peak.";
}

html::Row moment_row(const std::string& key, const Value& half, const Value& end) {
  const Quantity quantity = quantity_of(key);
  return {
      {quantity.name, half.exists() ? value_markup(half[key]) : Markup("–"), value_markup(end[key]), quantity.unit}};
}

Markup joined_words(const Value& value) {
  std::string text;
  for (const auto& [name, version] : value.entries()) text += (text.empty() ? "" : ", ") + name + " " + version.words();
  return text;
}

Markup file_link(const RunContext& context, const char* name) {
  return std::filesystem::exists(context.folder / name) ? html::link(name, name) : Markup(name);
}

/// What the run adds to the base model: nothing on the page can be read without it.
std::vector<Markup> mechanism_notice(const RunConfig& config) {
  const std::string entries = mechanism_words(config);
  if (entries.empty()) return {};
  return {html::notice(html::NoticeKind::information, "Not the base model: this run has " + entries + ".")};
}

}  // namespace

std::vector<Markup> run_warnings(const RunContext& context) {
  std::vector<Markup> notices = mechanism_notice(context.config);
  const std::string outcome = context.manifest["outcome"].text();
  if (outcome != "finished")
    notices.push_back(html::notice(html::NoticeKind::warning, "This run is not finished (" + outcome +
                                                                  "): " + context.manifest["exit_reason"].text()));
  for (const Value& warning : context.summary["warnings"].items())
    notices.push_back(html::notice(html::NoticeKind::warning, page_text(warning.words())));
  return notices;
}

html::Section results_section(const RunContext& context) {
  html::Section section{"Results", {}, {}};
  if (!context.config.description.empty()) section.parts.push_back(html::paragraph(context.config.description));
  html::Table table = quantity_table("Key results. Stresses are positive in compression; “–” was not reached.");
  for (const auto& [key, value] : context.summary["results"].entries())
    if (!value.is_list()) table.rows.push_back(quantity_row(key, value));
  const Value cracks = context.summary["cracks"], contacts = context.summary["contacts"];
  if (cracks.exists()) {
    table.rows.push_back({{"contacts broken in tension", value_markup(cracks["tension"]), "–"}});
    table.rows.push_back({{"contacts broken in shear", value_markup(cracks["shear"]), "–"}});
    table.rows.push_back(quantity_row("fragments", cracks["fragments"]));
  }
  if (contacts.exists())
    table.rows.push_back(quantity_row("largest_overlap_over_edge", contacts["largest_overlap_over_edge"]));
  const std::string stopped = context.summary["experiment"]["stopped"].text();
  if (!table.rows.empty()) section.parts.push_back(html::table(table));
  if (!stopped.empty()) section.parts.push_back(html::paragraph("The test " + stopped + "."));
  return section;
}

html::Section failure_mode_section(const RunContext& context) {
  html::Section section{"Failure mode", {}, {}};
  const Value failure = context.summary["failure_mode"], half = failure["at_half_peak"], end = failure["at_end"];
  if (!end.exists()) return section;
  const std::string when =
      half.exists() ? half["verdict"].words() + " when the stress had first fallen to half its peak; " : "";
  section.parts.push_back(html::paragraph("Verdict: " + when + end["verdict"].words() + " at the end."));
  html::Table table{
      "What had broken; angles from the loading axis, shares of crack length at rest.",
      {{"Measure", {}, ColumnKind::head}, {"At half the peak"}, {"At the end"}, {"Unit", {}, ColumnKind::text}},
      {}};
  for (const auto& [key, value] : end.entries())
    if (key != "verdict") table.rows.push_back(moment_row(key, half, end));
  section.parts.push_back(html::table(table));
  return section;
}

html::Section energy_section(const RunContext& context) {
  html::Section section{"Energy", {}, {}};
  const Value energy = context.summary["energy"];
  if (const auto figure = run_figure(
          context, "energy",
          "The energies stacked one on another over the curve's abscissa, and the external work as a line over them.",
          "Energy account: the stack's upper edge and the line of the external work coincide where it is closed."))
    section.parts.push_back(*figure);
  if (!energy.exists()) return section;
  section.parts.push_back(energy_table(energy));
  section.parts.push_back(html::paragraph(closure_sentence(energy)));
  return section;
}

html::Section events_section(const RunContext& context) {
  html::Section section{"Acoustic events", {}, {}};
  if (!std::filesystem::exists(context.folder / "events.csv")) return section;
  const CsvData events = read_csv(context.folder / "events.csv");
  if (events.rows() == 0) return section;
  const std::vector<double> energies = events.numbers("energy_n_mm"), cracks = events.numbers("cracks");
  const auto largest = static_cast<std::size_t>(std::max_element(energies.begin(), energies.end()) - energies.begin());
  section.parts.push_back(html::paragraph(
      Markup(fmt::format(
          "Cracks near in space and time make {} {}. The largest by fracture energy has {:.0f} {} and took ",
          events.rows(), events.rows() == 1 ? "event" : "events", cracks[largest],
          cracks[largest] == 1 ? "crack" : "cracks")) +
      html::number(energies[largest], 3) + " N mm, " + html::number(1e3 * events.numbers("time_s")[largest]) +
      " ms after the start. " + file_link(context, "events.csv") + " has them all."));
  if (const auto figure = run_figure(context, "acoustic",
                                     "Stress, number and energy of the events so far, and each event's magnitude, over "
                                     "the test.",
                                     "Events over the test."))
    section.parts.push_back(*figure);
  if (const auto figure =
          run_figure(context, "magnitudes", "Number of events of at least a magnitude, over the magnitude.",
                     "Frequency of magnitudes, with the completeness and, where there are enough events, b."))
    section.parts.push_back(*figure);
  return section;
}

html::Section run_cost_section(const RunContext& context) {
  html::Section section{"Cost", {}, {}};
  html::Table table = quantity_table("Wall times on the machine named under Provenance.");
  for (const auto& [key, value] : context.summary["cost"].entries()) table.rows.push_back(quantity_row(key, value));
  const Value render = context.manifest["timings"]["render_s"];
  if (render.exists()) table.rows.push_back(quantity_row("render_s", render));
  for (const char* key : {"triangles", "contacts", "time_step_s", "added_mass_fraction"})
    if (const Value value = context.summary["experiment"][key]; value.exists())
      table.rows.push_back(quantity_row(key, value));
  if (!table.rows.empty()) section.parts.push_back(html::table(table));
  return section;
}

html::Section run_provenance_section(const RunContext& context) {
  const Value& m = context.manifest;
  const std::string changed = m["dirty"].truth() ? ", files changed since" : "";
  html::Section section{"Provenance", {}, {}};
  section.parts.push_back(html::definition_list(
      {{"Configuration", Markup(context.config.name + ", as written: ") + file_link(context, "config.original.json") +
                             ", every value in force: " + file_link(context, "config.effective.json")},
       {"Hash of the configuration", html::code(m["config_hash"].text())},
       {"Code", "Asperity " + m["version"].text() + ", revision " + m["revision"].text() + changed + "; " +
                    m["compiler"].text() + ", " + m["build_type"].text()},
       {"Libraries", joined_words(m["libraries"])},
       {"Machine", m["host"]["cpu_model"].text() + ", " + m["host"]["cores"].words() + " logical processors, " +
                       m["threads"].words() + " used"},
       {"Seed", m["seed"].words()},
       {"Time (UTC)", m["started_utc"].text() + " to " + m["ended_utc"].text()},
       {"Outcome", m["outcome"].text() + ": " + m["exit_reason"].text()},
       {"Files", file_link(context, "summary.json") + ", " + file_link(context, "manifest.json") + ", " +
                     file_link(context, "curves.csv") + ", " + file_link(context, "energy.csv") + ", " +
                     file_link(context, "cracks.csv") + ", " + file_link(context, "events.csv") + ", " +
                     file_link(context, "fragments.csv") + "; for ParaView " + file_link(context, "fields.pvd") + ", " +
                     file_link(context, "cracks.pvd") + ", " + file_link(context, "contacts.pvd")}}));
  return section;
}

}  // namespace asperity::app
