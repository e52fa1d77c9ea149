#include "app/law/law_set.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/base/units.hpp"
#include "core/config/mechanism_declaration.hpp"
#include "core/contact/closed_forms.hpp"
#include "core/mechanism/mechanism.hpp"
#include "render/style.hpp"

namespace asperity::app {
namespace {

constexpr double kOwnWidth = 5, kOtherWidth = 3;  // pixels
constexpr double kPointRadius = 7;                // pixels

LawConfig of_reading(LawReading reading) {
  LawConfig law;
  law.reading = reading;
  return law;
}

std::string name_of(const LawConfig& law) {
  if (law.reading == LawReading::consistent)
    return law.form == LawForm::damage_slip ? "default law" : "default law, cohesive-frictional";
  std::string departures;
  if (law.shear_peak == ShearPeak::coulomb) departures += ", Coulomb peak";
  if (law.opening_shear_stiffness == OpeningShearStiffness::k_s) departures += ", k_{s} in opening";
  return "literal law" + (departures.empty() ? ", as printed" : departures);
}

NamedLaw named(const RunConfig& config, const LawConfig& law) { return {name_of(law), driven_law(config, law)}; }

/// "; mechanisms: crack_closure, ..." and of which the curves cannot tell.
std::string mechanism_words(const RunConfig& config) {
  std::string all, single;
  for (const MechanismConfig& entry : config.mechanisms) {
    if (is_off(entry)) continue;
    all += (all.empty() ? "" : ", ") + entry.type;
    if (marks_contacts(entry.type)) single += (single.empty() ? "" : ", ") + entry.type;
  }
  if (all.empty()) return "No mechanisms.";
  return "Mechanisms: " + all + "." +
         (single.empty() ? "" : " Drawn for a contact of strength factor 1: " + single + " changes single contacts.");
}

std::string parameter_words(const RunConfig& config) {
  const DerivedParameters d = derive(config, config.experiment.plane);
  const ContactConfig& c = config.contacts;
  return fmt::format(
      "k_{{t}} = {} and k_{{s}} = {} MPa/mm, t_{{c}} = {} and c_{{c}} = {} MPa, φ_{{c}} = {}°, G_{{f}} = {} N/mm, "
      "plane {}. ",
      short_number(d.k_t), short_number(d.k_s), short_number(c.tensile_strength_mpa), short_number(c.cohesion_mpa),
      short_number(c.friction_angle_deg), short_number(d.g_f),
      config.experiment.plane == PlaneCondition::stress ? "stress" : "strain");
}

std::string_view word_of(PathLeg leg) {
  return leg == PathLeg::loading ? "loading" : leg == PathLeg::unloading ? "unloading" : "reloading";
}

/// The middle point of every run of one leg that is not loading.
std::vector<std::size_t> middles(const LawPath& path) {
  std::vector<std::size_t> found;
  for (std::size_t from = 0; from < path.size();) {
    std::size_t to = from;
    while (to < path.size() && path[to].leg == path[from].leg) ++to;
    // Unloading and reloading may lie on one line: their heads stand apart.
    if (path[from].leg != PathLeg::loading) found.push_back(from + (to - from) * 3 / 4);
    from = to;
  }
  return found;
}

}  // namespace

std::string short_number(double value) {
  return std::abs(value) >= 100.0 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

LawSet law_set(const RunConfig& config) {
  const RunConfig applied = with_mechanisms(config);
  const bool literal = config.contacts.law.reading == LawReading::literal;
  return {named(applied, config.contacts.law),
          named(applied, of_reading(literal ? LawReading::consistent : LawReading::literal)), config.name,
          parameter_words(applied) + mechanism_words(config)};
}

std::vector<std::string> law_columns() {
  return {"law",    "path",  "leg", "opening_mm", "slip_mm", "normal_traction_mpa", "shear_traction_mpa",
          "damage", "broken"};
}

void add_rows(std::vector<std::vector<CsvCell>>& rows, const NamedLaw& law, const std::string& path_name,
              const LawPath& path) {
  const std::string_view reading = law.law.reading == LawReading::literal ? "literal" : "default";
  for (const PathPoint& p : path)
    rows.push_back({reading, std::string_view(path_name), word_of(p.leg), p.opening, p.slip, p.normal_traction,
                    p.shear_traction, p.damage, p.broken ? 1 : 0});
}

render::LineLayer line_of(const LawPath& path, PathView view, const std::string& label, const render::Stroke& stroke) {
  render::LineLayer line{label, {}, {}, stroke, 0, middles(path)};
  for (const PathPoint& p : path) {
    line.x.push_back(view == PathView::opening ? p.opening : p.slip);
    line.y.push_back(view == PathView::opening ? p.normal_traction : p.shear_traction);
  }
  return line;
}

render::Stroke own_stroke(render::Colour colour) { return {colour, kOwnWidth, {}, render::Cap::butt}; }

render::Stroke other_stroke(render::Colour colour) { return {colour, kOtherWidth, {12, 8}, render::Cap::butt}; }

render::PointLayer named_points(const std::vector<Vec2>& at, std::vector<std::string> names) {
  render::PointLayer points{
      "", {}, {}, {render::MarkerShape::ring, render::style::kInk, kPointRadius}, {}, {}, std::move(names)};
  for (const Vec2 p : at) {
    points.x.push_back(p.x);
    points.y.push_back(p.y);
  }
  return points;
}

}  // namespace asperity::app
