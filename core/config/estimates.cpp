#include "core/config/estimates.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/units.hpp"

namespace asperity {

namespace {

constexpr double kSqrt3 = std::numbers::sqrt3;

/// E~ of the paper's Eq 34, in MPa.
double plane_modulus(const MaterialConfig& material, PlaneCondition plane) {
  const double modulus = material.youngs_modulus_gpa * units::kMpaPerGpa;
  const double nu = material.poissons_ratio;
  return plane == PlaneCondition::stress ? modulus : modulus / (1.0 - nu * nu);
}

/// Eqs 12 and 13: 3 beta E E~ sigma_t / K^2 (and G for E in shear), in MPa/mm.
double zone_stiffness(const RunConfig& config, double elastic_modulus_mpa, double toughness_mpa_sqrt_m) {
  const MaterialConfig& m = config.material;
  const double toughness = toughness_mpa_sqrt_m * units::kMpaSqrtMmPerMpaSqrtM;
  return 3.0 * m.beta * elastic_modulus_mpa * plane_modulus(m, config.experiment.plane) * m.tensile_strength_mpa /
         (toughness * toughness);
}

double estimated_shear_stiffness(const RunConfig& config) {
  const MaterialConfig& m = config.material;
  const double shear_modulus = m.youngs_modulus_gpa * units::kMpaPerGpa / (2.0 * (1.0 + m.poissons_ratio));
  const double closed_form = zone_stiffness(config, shear_modulus, m.mode_ii_toughness_mpa_sqrt_m);
  return config.contacts.shear_stiffness_mpa_per_mm.value_or(closed_form);
}

/// Largest stiffness of an equilateral CST triangle over its thickness, in MPa: the third term of Eq. (K2).
double triangle_stiffness(const RunConfig& config) {
  const double modulus = config.particles.youngs_modulus_gpa * units::kMpaPerGpa;
  const double nu = config.particles.poissons_ratio;
  const bool plane_stress = config.experiment.plane == PlaneCondition::stress;
  const double dilating = plane_stress ? 1.0 - nu : (1.0 + nu) * (1.0 - 2.0 * nu);
  return 0.5 * kSqrt3 * modulus / std::min(dilating, 1.0 + nu);
}

}  // namespace

double estimated_tensile_stiffness(const RunConfig& config) {
  const MaterialConfig& m = config.material;
  const double closed_form =
      zone_stiffness(config, m.youngs_modulus_gpa * units::kMpaPerGpa, m.mode_i_toughness_mpa_sqrt_m);
  return config.contacts.tensile_stiffness_mpa_per_mm.value_or(closed_form);
}

double estimated_fracture_energy(const RunConfig& config) {
  const double toughness = config.material.mode_i_toughness_mpa_sqrt_m * units::kMpaSqrtMmPerMpaSqrtM;
  const double closed_form = toughness * toughness / plane_modulus(config.material, config.experiment.plane);
  return config.contacts.fracture_energy_n_per_mm.value_or(closed_form);
}

double hardening_energy(const RunConfig& config) {
  constexpr double e = std::numbers::e;
  const double strength = config.contacts.tensile_strength_mpa;
  return e * (e - 2.0) * strength * strength / estimated_tensile_stiffness(config);
}

double estimated_critical_step(const RunConfig& config) {
  const double edge = config.particles.edge_mm;
  const double density = config.particles.density_kg_per_m3 * units::kTonnePerMm3PerKgPerM3;
  const double node_mass = density * 0.25 * kSqrt3 * edge * edge / 3.0;  // Eq. (K1), per mm of thickness
  const double contact = std::max(estimated_tensile_stiffness(config), estimated_shear_stiffness(config));
  const double stiffness = 2.0 * contact * edge + triangle_stiffness(config);  // Eq. (K2), per mm of thickness
  const double step = 2.0 / std::sqrt(stiffness / node_mass);                  // Eq. (K3)
  const MassScalingConfig& scaling = config.integration.mass_scaling;
  const double scaled = (scaling.uniform ? scaling.time_step_factor : 1.0) * step;
  return std::max(scaled, config.integration.mass_scaling_time_step_s.value_or(0.0));
}

namespace {

double joint_length(const JointConfig& joint) {
  if (!joint.points_mm.empty()) return joint.points_mm.back().x - joint.points_mm.front().x;
  double length = joint.end_gap_mm;
  for (const ToothConfig& t : joint.profile) {
    length += t.gap_before_mm + 2.0 * t.height_mm / std::tan(t.angle_deg * units::kRadPerDeg);
  }
  return length;
}

/// Area of the particles' zones, the teeth's taken as full boxes, mm2.
double joint_zone_area(const JointConfig& joint) {
  double highest = 0.0;
  for (const ToothConfig& t : joint.profile) highest = std::max(highest, t.height_mm);
  return joint_length(joint) * (highest + joint.damage_depth_lower_mm + joint.damage_depth_upper_mm);
}

}  // namespace

double estimated_triangles(const RunConfig& config) {
  const ExperimentConfig& e = config.experiment;
  const double disc = 0.25 * std::numbers::pi * e.diameter_mm * e.diameter_mm;
  const double area = e.type == ExperimentType::brazilian      ? disc
                      : e.type == ExperimentType::direct_shear ? joint_zone_area(config.joint)
                                                               : e.width_mm * e.height_mm;
  return area / (0.25 * kSqrt3 * config.particles.edge_mm * config.particles.edge_mm);
}

double smallest_dimension(const RunConfig& config) {
  const ExperimentConfig& e = config.experiment;
  if (e.type == ExperimentType::brazilian) return e.diameter_mm;
  if (e.type == ExperimentType::direct_shear) {
    return std::min({joint_length(config.joint), config.joint.lower_height_mm, config.joint.upper_height_mm});
  }
  return std::min(e.width_mm, e.height_mm);
}

}  // namespace asperity
