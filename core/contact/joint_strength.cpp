#include "core/contact/joint_strength.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/base/units.hpp"

namespace asperity {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kSameAngleDeg = 0.01;
constexpr double kRounding = 1e-12;  // of 1 - tan i tan phi_j, where it should be 0

double sin_deg(double angle) { return std::sin(angle * units::kRadPerDeg); }
double cos_deg(double angle) { return std::cos(angle * units::kRadPerDeg); }
double tan_deg(double angle) { return std::tan(angle * units::kRadPerDeg); }

double cohesion_over_plan(const ToothedJoint& joint, double base_mm) {
  assert(joint.length_mm > 0.0);
  return joint.cohesion_mpa * base_mm / joint.length_mm;
}

/// From the foot of the loaded flank to the far end of the crest; the flank's own angle for a pointed tooth.
double crest_angle(const ToothedJoint::Tooth& tooth) {
  const double run = tooth.base_mm - tooth.height_mm / tan_deg(tooth.angle_deg);
  return std::min(tooth.angle_deg, std::atan2(tooth.height_mm, run) / units::kRadPerDeg);
}

/// The intact rock on the whole plan area: S_R of Eq. (C68).
double intact_strength(const ToothedJoint& joint, double sigma_n, const LadanyiArchambaultParameters& parameters) {
  if (parameters.intact == IntactStrength::mohr_coulomb) {
    return joint.cohesion_mpa + sigma_n * tan_deg(joint.friction_deg);
  }
  assert(parameters.tensile_strength_mpa > 0.0);
  const double sigma_c = closed_forms::uniaxial_strength(joint.cohesion_mpa, joint.friction_deg);
  const double n = sigma_c / parameters.tensile_strength_mpa;
  return sigma_c * (std::sqrt(1.0 + n) - 1.0) / n * std::sqrt(1.0 + n * sigma_n / sigma_c);
}

double total_base(const std::vector<ToothGroup>& groups) {
  double base = 0.0;
  for (const ToothGroup& group : groups) base += group.base_mm;
  return base;
}

ToothStage tooth_stage(const ToothedJoint& joint, const ToothGroup& group, double sigma_n) {
  using namespace closed_forms;
  ToothStage stage;
  stage.group = group;
  stage.dilation_slope = tan_deg(group.angle_deg);
  stage.sliding_mpa = sliding_strength(sigma_n, joint.joint_friction_deg, group.angle_deg);
  stage.base_shear_mpa = base_shear_strength(joint, group.base_mm, sigma_n);
  stage.plane_deg = weakest_plane(joint, group, sigma_n);
  stage.plane_shear_mpa = plane_shear_strength(joint, group, stage.plane_deg, sigma_n);
  stage.transition_mpa = transition_stress(joint, group);
  const bool slides = stage.sliding_mpa <= stage.plane_shear_mpa;
  stage.failure = slides ? JointFailure::sliding : JointFailure::shearing;
  stage.strength_mpa = slides ? stage.sliding_mpa : stage.plane_shear_mpa;
  return stage;
}

void append(StrengthEnvelope& table, const JointStrength& s) {
  const ToothStage& first = s.stages.front();
  table.normal_stress.push_back(s.normal_stress_mpa);
  table.sliding.push_back(first.sliding_mpa);
  table.base_shear.push_back(first.base_shear_mpa);
  table.plane_shear.push_back(first.plane_shear_mpa);
  table.strength.push_back(s.strength_mpa);
  table.staged_peak.push_back(s.staged_peak_mpa);
  table.together.push_back(s.together_mpa);
  table.ladanyi_archambault.push_back(s.ladanyi_archambault.shear_mpa);
  table.residual_low.push_back(s.residual_low_mpa);
  table.residual_high.push_back(s.residual_high_mpa);
}

}  // namespace

namespace closed_forms {

double uniaxial_strength(double cohesion_mpa, double friction_deg) {
  return 2.0 * cohesion_mpa * cos_deg(friction_deg) / (1.0 - sin_deg(friction_deg));
}

double sliding_strength(double normal_stress_mpa, double joint_friction_deg, double angle_deg) {
  const double inclination = joint_friction_deg + angle_deg;
  return inclination < 90.0 ? normal_stress_mpa * tan_deg(inclination) : kNever;
}

double base_shear_strength(const ToothedJoint& joint, double base_mm, double normal_stress_mpa) {
  if (base_mm <= 0.0) return kNever;
  return cohesion_over_plan(joint, base_mm) + normal_stress_mpa * tan_deg(joint.friction_deg);
}

double plane_shear_strength(const ToothedJoint& joint, const ToothGroup& group, double plane_deg,
                            double normal_stress_mpa) {
  const double inclination = plane_deg + joint.friction_deg;
  if (group.base_mm <= 0.0 || inclination >= 90.0) return kNever;
  const double length_ratio = sin_deg(group.angle_deg) / sin_deg(group.angle_deg + plane_deg);  // plane to base
  return cohesion_over_plan(joint, group.base_mm) * length_ratio * cos_deg(joint.friction_deg) / cos_deg(inclination) +
         normal_stress_mpa * tan_deg(inclination);
}

double weakest_plane(const ToothedJoint& joint, const ToothGroup& group, double normal_stress_mpa) {
  const double i = group.angle_deg, phi = joint.friction_deg;
  const double k = cohesion_over_plan(joint, group.base_mm) * sin_deg(i) * cos_deg(phi);
  if (k * cos_deg(i + phi) <= normal_stress_mpa * sin_deg(i) * sin_deg(i)) return 0.0;  // rises from the base on
  // k cos(2 theta + i + phi) = sigma_n sin^2(theta + i), written as a cos(2 psi) + b sin(2 psi) = sigma_n / 2 in
  // psi = theta + i.
  const double a = k * cos_deg(i - phi) + 0.5 * normal_stress_mpa;
  const double b = k * sin_deg(i - phi);
  const double psi = 0.5 * (std::atan2(b, a) + std::acos(0.5 * normal_stress_mpa / std::hypot(a, b)));
  return std::clamp(psi / units::kRadPerDeg - i, 0.0, group.crest_deg);
}

double transition_stress(const ToothedJoint& joint, const ToothGroup& group) {
  const double slide = joint.joint_friction_deg + group.angle_deg;
  const double plane = std::clamp(0.5 * (joint.joint_friction_deg - joint.friction_deg), 0.0, group.crest_deg);
  if (group.base_mm <= 0.0 || slide <= plane + joint.friction_deg) return kNever;
  if (slide >= 90.0) return 0.0;
  return plane_shear_strength(joint, group, plane, 0.0) / (tan_deg(slide) - tan_deg(plane + joint.friction_deg));
}

LadanyiArchambaultStrength ladanyi_archambault(const ToothedJoint& joint, double normal_stress_mpa,
                                               const LadanyiArchambaultParameters& parameters) {
  const std::vector<ToothGroup> groups = tooth_groups(joint);
  const double tan_i = groups.empty() ? 0.0 : tan_deg(groups.front().angle_deg);
  const double tan_j = tan_deg(joint.joint_friction_deg);
  const double sigma_t =
      parameters.transition_stress_mpa.value_or(uniaxial_strength(joint.cohesion_mpa, joint.friction_deg));
  LadanyiArchambaultStrength s;
  s.intact_mpa = intact_strength(joint, normal_stress_mpa, parameters);
  if (normal_stress_mpa >= sigma_t) return {s.intact_mpa, 1.0, 0.0, s.intact_mpa};
  const double margin = 1.0 - normal_stress_mpa / sigma_t;
  const double unsheared = std::pow(margin, parameters.sheared_exponent);
  s.sheared_area = 1.0 - unsheared;
  s.dilation_slope = std::pow(margin, parameters.dilation_exponent) * tan_i;
  const double numerator = normal_stress_mpa * unsheared * (s.dilation_slope + tan_j) + s.sheared_area * s.intact_mpa;
  const double denominator = 1.0 - unsheared * s.dilation_slope * tan_j;
  s.shear_mpa = denominator > kRounding ? numerator / denominator : kNever;
  return s;
}

}  // namespace closed_forms

std::vector<ToothGroup> tooth_groups(const ToothedJoint& joint) {
  std::vector<ToothedJoint::Tooth> teeth;
  for (const ToothedJoint::Tooth& tooth : joint.teeth) {
    if (tooth.angle_deg > 0.0 && tooth.base_mm > 0.0) teeth.push_back(tooth);
  }
  std::stable_sort(teeth.begin(), teeth.end(), [](const auto& a, const auto& b) { return a.angle_deg > b.angle_deg; });
  std::vector<ToothGroup> groups;
  for (const ToothedJoint::Tooth& tooth : teeth) {
    if (groups.empty() || groups.back().angle_deg - tooth.angle_deg > kSameAngleDeg) {
      groups.push_back({tooth.angle_deg, 0.0, crest_angle(tooth)});
    }
    groups.back().base_mm += tooth.base_mm;
    groups.back().crest_deg = std::min(groups.back().crest_deg, crest_angle(tooth));
  }
  return groups;
}

std::vector<ToothStage> tooth_sequence(const ToothedJoint& joint, double normal_stress_mpa) {
  std::vector<ToothStage> stages;
  for (const ToothGroup& group : tooth_groups(joint)) {
    stages.push_back(tooth_stage(joint, group, normal_stress_mpa));
    if (stages.back().failure == JointFailure::sliding) return stages;
  }
  if (stages.empty()) stages.push_back(tooth_stage(joint, ToothGroup{}, normal_stress_mpa));
  return stages;
}

JointStrength joint_strength(const ToothedJoint& joint, double normal_stress_mpa,
                             const LadanyiArchambaultParameters& parameters) {
  JointStrength s;
  s.normal_stress_mpa = normal_stress_mpa;
  s.uniaxial_strength_mpa = closed_forms::uniaxial_strength(joint.cohesion_mpa, joint.friction_deg);
  s.stages = tooth_sequence(joint, normal_stress_mpa);
  s.failure = s.stages.front().failure;
  s.strength_mpa = s.stages.front().strength_mpa;
  for (const ToothStage& stage : s.stages) s.staged_peak_mpa = std::max(s.staged_peak_mpa, stage.strength_mpa);
  s.together_mpa = closed_forms::base_shear_strength(joint, total_base(tooth_groups(joint)), normal_stress_mpa);
  s.ladanyi_archambault = closed_forms::ladanyi_archambault(joint, normal_stress_mpa, parameters);
  const auto [low, high] = std::minmax(joint.joint_friction_deg, joint.friction_deg);
  s.residual_low_mpa = normal_stress_mpa * tan_deg(low);
  s.residual_high_mpa = normal_stress_mpa * tan_deg(high);
  return s;
}

StrengthEnvelope strength_envelope(const ToothedJoint& joint, const std::vector<double>& normal_stresses_mpa,
                                   const LadanyiArchambaultParameters& parameters) {
  StrengthEnvelope table;
  for (const double sigma_n : normal_stresses_mpa) append(table, joint_strength(joint, sigma_n, parameters));
  return table;
}

}  // namespace asperity
