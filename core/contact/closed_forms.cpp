#include "core/contact/closed_forms.hpp"

#include <cmath>
#include <numbers>

#include "core/base/error.hpp"
#include "core/base/units.hpp"

namespace asperity::closed_forms {

double critical_displacement(double strength, double stiffness) { return std::numbers::e * strength / stiffness; }

double fracture_energy(double t_c, double delta_ct, double delta_ut) {
  return t_c * delta_ct * (std::numbers::e - 2.0) + 0.5 * t_c * (delta_ut - delta_ct);
}

double ultimate_tensile_displacement(double t_c, double delta_ct, double g_f) {
  return delta_ct + 2.0 * (g_f / t_c - delta_ct * (std::numbers::e - 2.0));
}

double effective_modulus(double e, double nu, PlaneCondition plane) {
  return plane == PlaneCondition::stress ? e : e / (1.0 - nu * nu);
}

double griffith_energy(double toughness, double effective_modulus) { return toughness * toughness / effective_modulus; }

double cohesive_zone_thickness(double g_f, double tensile_strength, double beta) {
  return g_f / (3.0 * beta * tensile_strength);
}

namespace {
// Eqs 12, 13 are Eq. (C11) with w of Eqs 35, 36; their plane-strain form carries 1 / (1 - nu^2) once: the E~ of w.
double material_thickness(const MaterialConfig& m, double toughness_mpa_sqrt_m, PlaneCondition plane) {
  const double modulus = effective_modulus(m.youngs_modulus_gpa * units::kMpaPerGpa, m.poissons_ratio, plane);
  const double g = griffith_energy(toughness_mpa_sqrt_m * units::kMpaSqrtMmPerMpaSqrtM, modulus);
  return cohesive_zone_thickness(g, m.tensile_strength_mpa, m.beta);
}
}  // namespace

double tensile_stiffness(const MaterialConfig& m, PlaneCondition plane) {
  return m.youngs_modulus_gpa * units::kMpaPerGpa / material_thickness(m, m.mode_i_toughness_mpa_sqrt_m, plane);
}

double shear_stiffness(const MaterialConfig& m, PlaneCondition plane) {
  const double shear_modulus = m.youngs_modulus_gpa * units::kMpaPerGpa / (2.0 * (1.0 + m.poissons_ratio));
  return shear_modulus / material_thickness(m, m.mode_ii_toughness_mpa_sqrt_m, plane);
}

double stiffness_ratio(const MaterialConfig& m) {
  const double ratio = m.mode_i_toughness_mpa_sqrt_m / m.mode_ii_toughness_mpa_sqrt_m;
  return ratio * ratio / (2.0 * (1.0 + m.poissons_ratio));
}

double stiffness_ratio_as_printed(const MaterialConfig& m) {
  const double ratio = m.mode_ii_toughness_mpa_sqrt_m / m.mode_i_toughness_mpa_sqrt_m;
  return ratio * ratio / (2.0 * (1.0 + m.poissons_ratio));
}

double beta(int m, int n) {
  const double ratio = (m + 1.0) / (n + 1.0);
  const double span = n - m;
  return (1.0 / m - 1.0 / n) / (std::pow(ratio, (m + 1.0) / span) - std::pow(ratio, (n + 1.0) / span));
}

double lennard_jones_alpha(int m, int n) { return std::pow(std::pow(n, n) / std::pow(m, m), 1.0 / (n - m)) / (n - m); }

double lennard_jones_potential(double x, double epsilon, double zeta, int m, int n) {
  return lennard_jones_alpha(m, n) * epsilon * (std::pow(zeta / x, n) - std::pow(zeta / x, m));
}

double lennard_jones_force(double x, double epsilon, double zeta, int m, int n) {
  return lennard_jones_alpha(m, n) * epsilon / x * (-n * std::pow(zeta / x, n) + m * std::pow(zeta / x, m));
}

double peak_force_separation(int m, int n) { return std::pow(n * (n + 1.0) / (m * (m + 1.0)), 1.0 / (n - m)); }

double cohesive_force(int m, int n) { return lennard_jones_force(peak_force_separation(m, n), 1.0, 1.0, m, n); }

double equilibrium_separation(int m, int n) { return std::pow(static_cast<double>(n) / m, 1.0 / (n - m)); }

double bond_density(double gamma, double x_0) { return gamma * 3.0 / (x_0 * x_0 * x_0); }

double bond_strength(double gamma, double p_c, double x_0) { return gamma * p_c / (x_0 * x_0); }

double bond_energy(double epsilon, double zeta, int m, int n) {
  return -lennard_jones_potential(zeta * equilibrium_separation(m, n), epsilon, zeta, m, n);
}

double bonds_in_zone(double gamma, double w, double a_z, double x_0) { return bond_density(gamma, x_0) * w * a_z; }

double bond_fracture_energy(double gamma, double w, double epsilon, double x_0) {
  return bonds_in_zone(gamma, w, 1.0, x_0) * epsilon;
}

double bond_fracture_energy_from_force(double gamma, double w, double zeta, double p_c, int m, int n) {
  const double epsilon = p_c * zeta / cohesive_force(m, n);
  return bond_fracture_energy(gamma, w, epsilon, zeta * equilibrium_separation(m, n));
}

double mixed_mode_energy(double mode_i_toughness, double mode_ii_toughness, double effective_modulus) {
  return griffith_energy(mode_i_toughness, effective_modulus) + griffith_energy(mode_ii_toughness, effective_modulus);
}

}  // namespace asperity::closed_forms

namespace asperity {

DerivedParameters derive(const RunConfig& config, PlaneCondition plane) {
  using namespace closed_forms;
  const MaterialConfig& m = config.material;
  const ContactConfig& c = config.contacts;
  const double modulus = effective_modulus(m.youngs_modulus_gpa * units::kMpaPerGpa, m.poissons_ratio, plane);
  DerivedParameters d;
  d.k_t = c.tensile_stiffness_mpa_per_mm.value_or(tensile_stiffness(m, plane));
  d.k_s = c.shear_stiffness_mpa_per_mm.value_or(shear_stiffness(m, plane));
  const double toughness = m.mode_i_toughness_mpa_sqrt_m * units::kMpaSqrtMmPerMpaSqrtM;
  d.g_f = c.fracture_energy_n_per_mm.value_or(griffith_energy(toughness, modulus));
  const double sliding_toughness = m.mode_ii_toughness_mpa_sqrt_m * units::kMpaSqrtMmPerMpaSqrtM;
  d.g_mixed = mixed_mode_energy(toughness, sliding_toughness, modulus);
  d.w = cohesive_zone_thickness(griffith_energy(toughness, modulus), m.tensile_strength_mpa, m.beta);
  d.w_sliding = cohesive_zone_thickness(griffith_energy(sliding_toughness, modulus), m.tensile_strength_mpa, m.beta);
  d.delta_ct = critical_displacement(c.tensile_strength_mpa, d.k_t);
  d.delta_cs = critical_displacement(c.cohesion_mpa, d.k_s);
  d.delta_ut = ultimate_tensile_displacement(c.tensile_strength_mpa, d.delta_ct, d.g_f);
  d.delta_us = d.delta_cs;
  if (c.shear_fracture_energy_n_per_mm) {  // Eq. (D9): Eq (C10)'s area with c_c and delta_cs
    d.delta_us = ultimate_tensile_displacement(c.cohesion_mpa, d.delta_cs, *c.shear_fracture_energy_n_per_mm);
  }
  return d;
}

LawParameters law_parameters(const RunConfig& config) {
  const DerivedParameters d = derive(config, config.experiment.plane);
  const ContactConfig& c = config.contacts;
  if (d.delta_ut <= d.delta_ct) {
    const double least = c.tensile_strength_mpa * d.delta_ct * (std::numbers::e - 2.0);
    throw Error(
        ErrorKind::config,
        {{"/contacts/fracture_energy_n_per_mm", "leaves no softening: delta_ut would not exceed delta_ct (Eq 10)",
          std::to_string(d.g_f), "above t_c delta_ct (e - 2) = " + std::to_string(least) + " N/mm",
          "raise the fracture energy, lower tensile_strength_mpa, or raise tensile_stiffness_mpa_per_mm"}});
  }
  if (d.delta_us < d.delta_cs) {
    const double least = c.cohesion_mpa * d.delta_cs * (std::numbers::e - 2.0);
    throw Error(ErrorKind::config,
                {{"/contacts/shear_fracture_energy_n_per_mm",
                  "is less than the contact takes up to its shear peak: delta_us would lie below delta_cs (Eq D9)",
                  std::to_string(*c.shear_fracture_energy_n_per_mm),
                  "at least c_c delta_cs (e - 2) = " + std::to_string(least) + " N/mm",
                  "raise it, leave it out for Eq 6's drop, or raise shear_stiffness_mpa_per_mm"}});
  }
  const ModelExtensions& x = config.extensions;
  if (x.peak_friction_angle_deg.value_or(0.0) >= 90.0) {
    throw Error(ErrorKind::config,
                {{"/mechanisms", "coulomb_peak leads the peak's friction angle to a right angle or beyond",
                  std::to_string(*x.peak_friction_angle_deg), "below 90 degrees with phi_c",
                  "lower its excess_deg or amplitude"}});
  }
  LawParameters p;
  p.k_t = d.k_t;
  p.k_s = d.k_s;
  p.t_c = c.tensile_strength_mpa;
  p.c_c = c.cohesion_mpa;
  p.tan_phi = std::tan(c.friction_angle_deg * units::kRadPerDeg);
  p.delta_ct = d.delta_ct;
  p.delta_cs = d.delta_cs;
  p.delta_ut = d.delta_ut;
  p.kappa_ut = d.delta_ut / d.delta_ct;
  p.kappa_us = d.delta_us / d.delta_cs;
  p.inverse_delta_ct = 1.0 / d.delta_ct;
  p.tan_phi_peak = x.peak_friction_angle_deg ? std::tan(*x.peak_friction_angle_deg * units::kRadPerDeg) : p.tan_phi;
  p.coulomb = c.law.shear_peak == ShearPeak::coulomb ? p.tan_phi_peak : 0.0;
  p.envelope_exponent = x.envelope_exponent;
  p.friction_share = p.tan_phi_peak > 0.0 ? p.tan_phi / p.tan_phi_peak : 1.0;
  p.closure_share = 1.0 - x.closure_stiffness_ratio;
  if (x.closure_length_mm > 0.0) p.closure_length = x.closure_length_mm;
  p.opening_shear = c.law.opening_shear_stiffness == OpeningShearStiffness::k_s ? p.k_s / p.k_t : 1.0;
  return p;
}

}  // namespace asperity
