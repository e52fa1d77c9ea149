#include "core/experiment/joint_results.hpp"

#include <algorithm>
#include <cmath>

#include "core/experiment/joint_verdict.hpp"
#include "core/measurement/drops.hpp"
#include "core/measurement/joint_curve.hpp"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

/// Share of the displacement at the end of which the mean shear stress is the residual one.
constexpr double kResidualShare = 0.25;
/// A fall of the shear stress by this share of the peak, from a maximum to the minimum that follows, is a drop.
constexpr double kDrop = 0.1;
/// Share of the peak's displacement from which its dilation rate counts.
constexpr double kRateShare = 0.3;

std::vector<double> column(const std::vector<Sample>& samples, double (*value)(const Sample&)) {
  std::vector<double> values(samples.size());
  std::transform(samples.begin(), samples.end(), values.begin(), value);
  return values;
}
std::vector<double> displacements(const std::vector<Sample>& samples) {
  return column(samples, [](const Sample& s) { return s.closure_mm; });
}
std::vector<double> stresses(const std::vector<Sample>& samples) {
  return column(samples, [](const Sample& s) { return s.stress_mpa; });
}

/// Eq. (E12).
double residual_stress(const std::vector<Sample>& samples) {
  return mean_at(stresses(samples), late_rows(displacements(samples), kResidualShare));
}

/// Eq. (E14), up to the peak's displacement.
double dilation_rate(const std::vector<Sample>& samples, double peak_mm) {
  const auto dilation = column(samples, [](const Sample& s) { return s.joint.dilation.mean; });
  return slope_between(displacements(samples), dilation, kRateShare * peak_mm, peak_mm).value_or(0.0);
}

/// Eq. (E13).
Json drops(const std::vector<Sample>& samples, double peak) {
  Json list = Json::array();
  for (const Drop& drop : find_drops(stresses(samples), kDrop * peak)) {
    list.push_back({{"from_mm", samples[drop.high].closure_mm},
                    {"to_mm", samples[drop.low].closure_mm},
                    {"from_mpa", samples[drop.high].stress_mpa},
                    {"to_mpa", samples[drop.low].stress_mpa}});
  }
  return list;
}

Json vector_entries(Vec2 force, double length) {
  return {{"shear_mpa", force.x / length}, {"normal_mpa", force.y / length}};
}

/// null for "not this way".
Json finite(double x) { return std::isfinite(x) ? Json(x) : Json(); }

Json form_entry(double strength_mpa, double simulated_mpa, const char* what) {
  const bool comparable = std::isfinite(strength_mpa) && strength_mpa > 0.0;
  return {{"shear_stress_mpa", finite(strength_mpa)},
          {"simulated_over_it", comparable ? Json(simulated_mpa / strength_mpa) : Json()},
          {"what", what}};
}

Json stage_entries(const std::vector<ToothStage>& stages) {
  Json list = Json::array();
  for (const ToothStage& s : stages) {
    list.push_back({{"angle_deg", s.group.angle_deg},
                    {"sliding_mpa", finite(s.sliding_mpa)},
                    {"base_shear_mpa", finite(s.base_shear_mpa)},
                    {"transition_normal_stress_mpa", finite(s.transition_mpa)},
                    {"predicted", s.failure == JointFailure::sliding ? "slides" : "shears"},
                    {"strength_mpa", finite(s.strength_mpa)}});
  }
  return list;
}

/// Tooth `i` from 0.
Json tooth_entry(const Model& model, const RunState& state, const TeethVerdict& verdict, std::size_t i) {
  const double length = model.joint.profile.length();
  const ToothSpan& span = model.joint.profile.teeth[i];
  const ToothHistory& history = verdict.teeth[i];
  const Sample* off = history.sheared_off ? &state.samples[*history.sheared_off] : nullptr;
  const ToothReading& at_peak = state.samples[find_peak(state.samples, peak_limit(model.config)).index].joint.teeth[i];
  const ToothReading& at_end = state.samples.back().joint.teeth[i];
  return {{"angle_deg", span.back_angle_deg},
          {"begin_mm", span.begin_mm},
          {"end_mm", span.end_mm},
          {"sheared_off", off != nullptr},
          {"sheared_off_at_mm", off ? Json(off->closure_mm) : Json()},
          {"shear_stress_then_mpa", off ? Json(off->stress_mpa) : Json()},
          {"attached_share_at_end", at_end.attached_share},
          {"cracks", at_end.cracks},
          {"leading_flank_at_peak", vector_entries(at_peak.leading, length)},
          {"trailing_flank_at_peak", vector_entries(at_peak.trailing, length)},
          {"leading_flank_most_mpa", history.largest_mpa},
          {"leading_flank_most_at_mm", history.largest_at_mm},
          {"share_of_most_with_first", verdict.first ? Json(history.share_with_first) : Json()}};
}

}  // namespace

std::optional<ToothedJoint> toothed_joint(const RunConfig& config, const JointProfile& profile) {
  const MaterialConfig& m = config.material;
  if (!m.cohesion_mpa || !m.friction_angle_deg) return std::nullopt;
  ToothedJoint joint;
  joint.length_mm = profile.length();
  for (const ToothSpan& t : profile.teeth) {
    joint.teeth.push_back({t.end_mm - t.begin_mm, t.height_mm, t.back_angle_deg});
  }
  joint.joint_friction_deg =
      config.contacts.general.outline.friction_angle_deg.value_or(config.contacts.friction_angle_deg);
  joint.cohesion_mpa = *m.cohesion_mpa;
  joint.friction_deg = *m.friction_angle_deg;
  return joint;
}

Json closed_form_entries(const Model& model, const RunState& state) {
  const std::optional<ToothedJoint> joint = toothed_joint(model.config, model.joint.profile);
  if (!joint) return {};
  const JointStrength s = joint_strength(*joint, model.config.experiment.normal_stress_mpa);
  const double peak = find_peak(state.samples, peak_limit(model.config)).stress_mpa;
  const double residual = residual_stress(state.samples);
  const ToothStage& first = s.stages.front();
  Json j;
  j["sliding"] = form_entry(first.sliding_mpa, peak, "sigma_n tan(phi_j + i), steepest teeth (C61)");
  j["shearing_through"] = form_entry(first.base_shear_mpa, peak, "C base/L + sigma_n tan(phi), steepest teeth (C62)");
  j["together"] = form_entry(s.together_mpa, peak, "all teeth sheared at once (C70)");
  j["staggered"] = form_entry(s.staged_peak_mpa, peak, "teeth one after the other, the largest (C71)");
  j["ladanyi_archambault"] = form_entry(s.ladanyi_archambault.shear_mpa, peak, "Ladanyi & Archambault (C66-C68)");
  j["residual_joint_friction"] = form_entry(s.residual_low_mpa, residual, "sigma_n tan(phi_j), on the residual (C69)");
  j["residual_rock_friction"] = form_entry(s.residual_high_mpa, residual, "sigma_n tan(phi), on the residual (C69)");
  j["stages"] = stage_entries(s.stages);
  j["predicted"] = s.failure == JointFailure::sliding ? "slides" : "shears";
  return j;
}

Json joint_results(const Model& model, const RunState& state, const Peak& peak) {
  const Sample& last = state.samples.back();
  const Sample& at_peak = state.samples[peak.index];
  return {{"normal_stress_mpa", model.config.experiment.normal_stress_mpa},
          {"peak_shear_stress_mpa", peak.stress_mpa},
          {"residual_shear_stress_mpa", residual_stress(state.samples)},
          {"peak_shear_displacement_mm", at_peak.closure_mm},
          {"end_shear_displacement_mm", last.closure_mm},
          {"end_dilation_mm", last.joint.dilation.mean},
          {"peak_dilation_mm", at_peak.joint.dilation.mean},
          {"dilation_rate_before_peak", dilation_rate(state.samples, at_peak.closure_mm)},
          {"peak_passed", !peak.at_end},
          {"drops", drops(state.samples, peak.stress_mpa)}};
}

Json tooth_entries(const Model& model, const RunState& state) {
  Json teeth = Json::array();
  const std::size_t count = model.joint.gauge.tooth_area_mm2.size();
  const TeethVerdict verdict = judge_teeth(state.samples, count, model.joint.profile.length());
  for (std::size_t i = 0; i < count; ++i) teeth.push_back(tooth_entry(model, state, verdict, i));
  return {{"teeth_failed", teeth_failure_name(verdict.failure)},
          {"first_tooth_to_fail", verdict.first ? Json(*verdict.first + 1) : Json()},
          {"teeth", teeth},
          {"closed_forms", closed_form_entries(model, state)}};
}

}  // namespace asperity
