#include "app/report/joint_reasons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/joint_words.hpp"
#include "core/base/units.hpp"

namespace asperity::app {
namespace {

/// Two figures that differ by less than this share are said to agree.
constexpr double kAgrees = 0.03;

bool agrees(double simulated, double predicted) { return std::abs(simulated / predicted - 1) < kAgrees; }

std::string agreement(double simulated, double predicted) {
  return fmt::format("The two agree within {:.0f} %. ", 100 * kAgrees) +
         (simulated == predicted ? "" : fmt::format("The simulation is {}. ", percent_apart(simulated, predicted)));
}

double friction_mpa(double normal_mpa, double angle_deg) {
  return normal_mpa * std::tan(angle_deg * units::kRadPerDeg);
}

double slope_deg(double rate) { return std::atan(rate) / units::kRadPerDeg; }

/// "tooth 1 was sheared off at 0.92 mm" of the first to fail.
std::string first_failure(const JointNumbers& n) {
  return fmt::format("{} was sheared off at {}", tooth_name(n, *n.first), mm(*n.teeth[*n.first].sheared_off_mm));
}

/// What the slope on which the upper half really rose makes of sliding.
std::string on_its_own_slope(const JointNumbers& n) {
  if (!std::isfinite(n.dilation_rate)) return "";
  const double angle = slope_deg(n.dilation_rate), steepest = n.forms.stages.front().group.angle_deg;
  const double own = closed_forms::sliding_strength(n.normal_mpa, n.joint.joint_friction_deg, angle);
  if (!std::isfinite(own)) return "";
  return fmt::format(
      "Before the peak the upper half rose by {} mm per mm, a slope of {}, where rigid flanks of {} give {}: rock and "
      "joint's spring give way before the flanks part. On that slope sliding takes {}, {} the simulated peak. ",
      decimals(n.dilation_rate, 3), degrees(angle), degrees(steepest),
      decimals(std::tan(steepest * units::kRadPerDeg), 3), mpa(own),
      agrees(n.peak_mpa, own) ? fmt::format("within {:.0f} % of", 100 * kAgrees)
                              : fmt::format("{:.2f} times", own / n.peak_mpa));
}

/// How far the base's cohesion was asked: what the peak leaves after the rock's friction, over C.
std::string mobilised(const JointNumbers& n, double base_mm) {
  const double left = (n.peak_mpa - friction_mpa(n.normal_mpa, n.joint.friction_deg)) * n.length_mm / base_mm;
  return fmt::format("Less the rock's friction of {}, the peak leaves {} on the base, {:.0f} % of C = {}. ",
                     mpa(friction_mpa(n.normal_mpa, n.joint.friction_deg)), mpa(left),
                     100 * left / n.joint.cohesion_mpa, mpa(n.joint.cohesion_mpa));
}

/// Whether the rock failed bit by bit before the peak.
std::string progressive(const JointNumbers& n, double base_mm) {
  if (n.softening_at_peak == 0 && n.at_peak.length_mm == 0) return "";
  const std::string broken =
      n.at_peak.length_mm == 0 ? "no contact had broken yet"
                               : fmt::format("contacts of {} in all had broken ({:.0f} % of the base's {})",
                                             mm(n.at_peak.length_mm), 100 * n.at_peak.length_mm / base_mm, mm(base_mm));
  std::string text = fmt::format(
      "At the peak {} and {} were softening: the cohesion is not borne all along at once, as the closed form has it. ",
      broken, n.softening_at_peak);
  if (n.softening_at_peak > 0 && n.shear_fracture_energy_n_per_mm)
    text += fmt::format("In shear they lose it over G_II = {} N/mm. ", decimals(*n.shear_fracture_energy_n_per_mm, 3));
  return text;
}

/// Where the cracks lie, if that is not the base.
std::string plane_of_cracks(const JointNumbers& n) {
  const BrokenNumbers& b = n.at_end;
  if (b.length_mm == 0) return "";
  std::string text;
  if (std::abs(b.mean_height_mm) > 0.5 * n.edge_mm)
    text = fmt::format("The broken contacts lie {} ± {} {} the base's plane, not on it. ",
                       mm(std::abs(b.mean_height_mm)), mm(b.height_sd_mm), b.mean_height_mm < 0 ? "below" : "above");
  else if (b.height_sd_mm > n.edge_mm)
    text = fmt::format("The broken contacts are spread by ± {} about the base's plane: they are not one plane. ",
                       mm(b.height_sd_mm));
  if (b.tension_share > 0.1)
    text +=
        fmt::format("{:.0f} % of their length broke in tension, where C and φ are not asked. ", 100 * b.tension_share);
  return text;
}

/// What the closed form leaves out that raises the peak, as far as it was measured.
std::string borne_elsewhere(const JointNumbers& n) {
  std::string text;
  if (n.leading_share_at_peak < 0.95)
    text += fmt::format("The leading flanks bore {:.0f} % of the shear stress at the peak; the rest passed elsewhere. ",
                        100 * n.leading_share_at_peak);
  if (std::abs(n.normal_at_peak_mpa / n.normal_mpa - 1) > 0.02)
    text += fmt::format("The normal stress was {} at the peak, not {}: the upper block's inertia. ",
                        mpa(n.normal_at_peak_mpa), mpa(n.normal_mpa));
  return text;
}

std::string why_below_or_above(const JointNumbers& n, double predicted, double base_mm) {
  std::string text = mobilised(n, base_mm);
  if (n.peak_mpa < predicted) return text + progressive(n, base_mm) + plane_of_cracks(n) + borne_elsewhere(n);
  const std::string more = plane_of_cracks(n) + borne_elsewhere(n);
  return text + (more.empty() ? "Why it is more, the run's own numbers do not tell. " : more);
}

std::string why_sliding(const JointNumbers& n) {
  const ToothStage& s = n.forms.stages.front();
  if (!std::isfinite(s.sliding_mpa))
    return fmt::format("φ_j + i = {} reaches 90°: these flanks cannot be slid up.",
                       degrees(n.joint.joint_friction_deg + s.group.angle_deg));
  if (!n.first) {
    const std::string head = agrees(n.peak_mpa, s.sliding_mpa)
                                 ? agreement(n.peak_mpa, s.sliding_mpa)
                                 : fmt::format("The simulation is {}. ", percent_apart(n.peak_mpa, s.sliding_mpa));
    return "No tooth was sheared off. " + head + on_its_own_slope(n);
  }
  std::string text = capital(first_failure(n)) + ", so that the flanks were not slid up to their crests. ";
  if (s.sliding_mpa > s.plane_shear_mpa)
    text += fmt::format("Shearing through asks for less ({}): σ_n = {} is above the transition stress, {}. ",
                        mpa(s.plane_shear_mpa), mpa(n.normal_mpa), mpa(s.transition_mpa));
  return text + on_its_own_slope(n);
}

std::string why_shearing(const JointNumbers& n) {
  const ToothStage& s = n.forms.stages.front();
  if (!n.first)
    return fmt::format("No tooth was sheared off up to {}, so that the base's strength was not reached. ",
                       mm(n.end_mm)) +
           (n.peak_mpa > s.base_shear_mpa ? mobilised(n, s.group.base_mm) : "");
  if (agrees(n.peak_mpa, s.base_shear_mpa)) return agreement(n.peak_mpa, s.base_shear_mpa);
  return why_below_or_above(n, s.base_shear_mpa, s.group.base_mm);
}

std::string why_together(const JointNumbers& n) {
  if (n.teeth_failed == "together") {
    double base = 0;
    for (const ToothGroup& group : tooth_groups(n.joint)) base += group.base_mm;
    return "The teeth did fail together. " + why_below_or_above(n, n.forms.together_mpa, base);
  }
  if (!n.first) return "No tooth was sheared off. ";
  return fmt::format("Not all were loaded at once: {}. ", unequal_loads(n));
}

std::string why_staggered(const JointNumbers& n) {
  if (!n.first) return "No tooth was sheared off. ";
  const ToothStage& s = n.forms.stages.front();
  if (n.teeth_failed == "together")
    return fmt::format("The teeth failed together, so that the steepest did not carry alone: {}. ", unequal_loads(n));
  const double largest = n.teeth[*n.first].most_mpa;
  return fmt::format("{}, having borne at most {} of the shear stress on its leading flank; alone it should bear {}. ",
                     capital(first_failure(n)), mpa(largest), mpa(s.strength_mpa)) +
         (agrees(n.peak_mpa, n.forms.staged_peak_mpa)
              ? agreement(n.peak_mpa, n.forms.staged_peak_mpa)
              : why_below_or_above(n, n.forms.staged_peak_mpa, s.group.base_mm));
}

std::string why_ladanyi(const JointNumbers& n) {
  const LadanyiArchambaultStrength& l = n.forms.ladanyi_archambault;
  double base = 0;
  for (const ToothNumbers& t : n.teeth) base += t.base_mm;
  return fmt::format(
      "It takes {:.0f} % of the plan area as sheared, at the intact rock's {}, and the rest as sliding with a dilation "
      "of "
      "{} mm per mm; simulated before the peak: {}. The teeth cover {:.0f} % of the plan area{}. ",
      100 * l.sheared_area, mpa(l.intact_mpa), decimals(l.dilation_slope, 3), decimals(n.dilation_rate, 3),
      100 * base / n.length_mm, n.first ? "" : ", and none was sheared off");
}

/// Whether what was averaged is friction on a sheared base at all.
std::string residual_state(const JointNumbers& n) {
  const double from = 0.75 * n.end_mm;
  std::string text;
  for (std::size_t k = 0; k < n.teeth.size(); ++k) {
    const ToothNumbers& t = n.teeth[k];
    if (!t.sheared_off_mm)
      text += fmt::format("{} still stands. ", capital(tooth_name(n, k)));
    else if (*t.sheared_off_mm > from)
      text += fmt::format("{} was sheared off at {} only, inside the last quarter ({} to {}) that is averaged. ",
                          capital(tooth_name(n, k)), mm(*t.sheared_off_mm), mm(from), mm(n.end_mm));
  }
  return text;
}

/// What friction of this angle makes on the slope that the upper half moved along in the last quarter.
std::string on_last_slope(const JointNumbers& n, const char* whose, double angle_deg, double predicted) {
  const double slope = slope_deg(n.last_quarter_slope);
  return fmt::format("On that slope the {} friction makes {}. ", whose,
                     mpa(friction_mpa(n.normal_mpa, angle_deg + slope))) +
         (agrees(n.residual_mpa, predicted) ? agreement(n.residual_mpa, predicted) : "");
}

std::string why_residual(const JointNumbers& n) {
  std::string text = residual_state(n);
  text += fmt::format("The residual is a friction of {}. Over the last quarter the upper half {} by {} mm per mm",
                      degrees(slope_deg(n.residual_mpa / n.normal_mpa)), n.last_quarter_slope < 0 ? "sank" : "rose",
                      decimals(std::abs(n.last_quarter_slope), 3));
  text += n.last_quarter_cracks > 0
              ? fmt::format(", and {} more contacts broke: rubble is still being ground. ", n.last_quarter_cracks)
              : ". ";
  return text + on_last_slope(n, "joint's", n.joint.joint_friction_deg, n.forms.residual_low_mpa);
}

std::string why_transition(const JointNumbers& n) {
  const ToothStage& s = n.forms.stages.front();
  const bool shears = s.failure == JointFailure::shearing;
  const bool sheared = n.first.has_value();
  return fmt::format("The applied normal stress is {} it: the steepest teeth should {}. In the simulation {}, {}. ",
                     n.normal_mpa > s.transition_mpa ? "above" : "below", shears ? "shear" : "slide",
                     sheared ? first_failure(n) : "none was sheared off",
                     shears == sheared ? "as predicted" : "against it");
}

}  // namespace

std::vector<FormBeside> forms_beside(const JointNumbers& n) {
  const ToothStage& s = n.forms.stages.front();
  std::vector<FormBeside> all{{"sliding up the flanks", "C61", s.sliding_mpa, n.peak_mpa, "peak", why_sliding(n)}};
  if (s.group.base_mm > 0) {
    all.push_back({"sheared through at the base", "C62", s.base_shear_mpa, n.peak_mpa, "peak", why_shearing(n)});
    all.push_back({"transition, normal stress", "C65", s.transition_mpa, n.normal_mpa, "applied", why_transition(n)});
  }
  if (n.teeth.size() > 1) {
    all.push_back({"teeth one after the other", "C71", n.forms.staged_peak_mpa, n.peak_mpa, "peak", why_staggered(n)});
    all.push_back({"all teeth at once", "C70", n.forms.together_mpa, n.peak_mpa, "peak", why_together(n)});
  }
  all.push_back(
      {"Ladanyi & Archambault", "C66", n.forms.ladanyi_archambault.shear_mpa, n.peak_mpa, "peak", why_ladanyi(n)});
  all.push_back(
      {"residual, joint's friction", "C69", n.forms.residual_low_mpa, n.residual_mpa, "residual", why_residual(n)});
  all.push_back({"residual, rock's friction", "C69", n.forms.residual_high_mpa, n.residual_mpa, "residual",
                 "As above. " + on_last_slope(n, "rock's", n.joint.friction_deg, n.forms.residual_high_mpa)});
  return all;
}

}  // namespace asperity::app
