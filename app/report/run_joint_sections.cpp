#include <fmt/format.h>

#include <cmath>

#include "app/report/joint_reasons.hpp"
#include "app/report/joint_words.hpp"
#include "app/report/quantities.hpp"
#include "app/report/run_parts.hpp"

namespace asperity::app {
namespace {

using html::ColumnKind;
using html::Markup;

Markup teeth_table(const Value& teeth) {
  html::Table table{
      "Each tooth of the lower half, counted along x, the direction in which it moves. Stresses are shares of the "
      "joint's "
      "shear stress; a tooth is sheared off once less than half of it hangs together with the lower half (E15).",
      {{"Tooth", {}, ColumnKind::head},
       {"Angle", "°"},
       {html::lines({"Sheared", "off at"}), "mm"},
       {html::lines({"Shear stress", "then"}), "MPa"},
       {html::lines({"Leading flank", "at the peak"}), "MPa"},
       {html::lines({"Trailing flank", "at the peak"}), "MPa"},
       {html::lines({"Leading", "flank's most"}), "MPa"},
       {"at", "mm"},
       {html::lines({"Attached", "at the end"}), "%"},
       {html::lines({"Broken", "contacts"})}},
      {}};
  int number = 0;
  for (const Value& t : teeth.items())
    table.rows.push_back(
        {{std::to_string(++number), html::fixed(t["angle_deg"].number(), 1),
          html::fixed(t["sheared_off_at_mm"].number(), 3), html::fixed(t["shear_stress_then_mpa"].number(), 3),
          html::fixed(t["leading_flank_at_peak"]["shear_mpa"].number(), 3),
          html::fixed(t["trailing_flank_at_peak"]["shear_mpa"].number(), 3),
          html::fixed(t["leading_flank_most_mpa"].number(), 3), html::fixed(t["leading_flank_most_at_mm"].number(), 3),
          html::fixed(100 * t["attached_share_at_end"].number(), 0), std::to_string(t["cracks"].count())}});
  return html::table(table);
}

Markup drops_table(const Value& drops) {
  html::Table table{
      "Falls of the shear stress by a tenth of the peak or more, each from a maximum to the least stress before "
      "it rises by as much again (E13).",
      {{"Drop", {}, ColumnKind::head}, {"from", "mm"}, {"to", "mm"}, {"from", "MPa"}, {"to", "MPa"}},
      {}};
  int number = 0;
  for (const Value& d : drops.items())
    table.rows.push_back(
        {{std::to_string(++number), html::fixed(d["from_mm"].number(), 3), html::fixed(d["to_mm"].number(), 3),
          html::fixed(d["from_mpa"].number(), 3), html::fixed(d["to_mpa"].number(), 3)}});
  return html::table(table);
}

html::Section drops_section(const RunContext& context) {
  html::Section section{"Sequence of drops", {}, {}};
  const Value drops = context.summary["results"]["drops"];
  if (!drops.exists()) return section;
  section.parts.push_back(drops.items().empty() ? html::paragraph("The shear stress never fell by a tenth of its peak.")
                                                : drops_table(drops));
  return section;
}

html::Section verdict_section(const RunContext& context) {
  html::Section section{"Verdict: together or one after the other", {}, {}};
  const bool judged = context.joint && !context.joint->teeth_failed.empty() && context.joint->teeth.size() > 1;
  if (!judged) return section;
  std::vector<Markup> sentences;
  for (const std::string& sentence : teeth_story(*context.joint, context.curves))
    sentences.push_back(page_text(sentence));
  section.parts.push_back(html::paragraph(html::strong(sentences.front())));
  sentences.erase(sentences.begin());
  section.parts.push_back(html::bullet_list(sentences));
  return section;
}

html::Row form_row(const FormBeside& form) {
  const bool comparable = std::isfinite(form.predicted_mpa) && form.predicted_mpa > 0;
  return {{form.name, form.equation, html::fixed(form.predicted_mpa, 3),
           html::fixed(form.simulated_mpa, 3) + " (" + form.simulated_name + ")",
           comparable ? html::fixed(form.simulated_mpa / form.predicted_mpa, 3) : Markup("–"), page_text(form.why)}};
}

}  // namespace

html::Section teeth_section(const RunContext& context) {
  html::Section section{"Teeth", {}, {}};
  const Value teeth = context.summary["failure_mode"]["teeth"];
  if (!context.sheared() || teeth.items().empty()) return section;
  section.parts.push_back(teeth_table(teeth));
  if (const auto figure =
          run_figure(context, "teeth",
                     "Shear stress of the whole joint and what each tooth's leading and trailing flank bears of it "
                     "over the shear displacement, with upright lines where teeth were sheared off.",
                     "Shear force of each tooth's flanks over the joint's plan area; upright lines: sheared off."))
    section.parts.push_back(*figure);
  for (html::Section inner : {verdict_section(context), drops_section(context)})
    if (!inner.parts.empty()) section.sections.push_back(std::move(inner));
  return section;
}

html::Section closed_forms_section(const RunContext& context) {
  html::Section section{"Closed forms beside the simulation", {}, {}};
  if (!context.sheared() || !context.summary.exists()) return section;
  if (!context.joint) {
    section.parts.push_back(
        html::notice(html::NoticeKind::information,
                     "Closed forms need the rock's cohesion and friction angle: /material/cohesion_mpa "
                     "and /material/friction_angle_deg of the configuration."));
    return section;
  }
  html::Table table{page_text(fmt::format(
                        "Strengths on the plan area under a normal stress of {}, with C = {}, φ = {}, φ_j = {}. "
                        "Equations: core/contact/README.md.",
                        mpa(context.joint->normal_mpa), mpa(context.joint->joint.cohesion_mpa),
                        degrees(context.joint->joint.friction_deg), degrees(context.joint->joint.joint_friction_deg))),
                    {{"Closed form", {}, ColumnKind::head},
                     {"Eq.", {}, ColumnKind::text},
                     {"Predicted", "MPa"},
                     {"Simulated", "MPa"},
                     {html::lines({"Simulated", "/ predicted"})},
                     {"Why they differ", {}, ColumnKind::prose}},
                    {}};
  for (const FormBeside& form : forms_beside(*context.joint)) table.rows.push_back(form_row(form));
  section.parts.push_back(html::table(table));
  return section;
}

}  // namespace asperity::app
