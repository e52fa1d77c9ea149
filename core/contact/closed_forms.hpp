#pragma once
#include "core/config/run_config.hpp"
#include "core/contact/law.hpp"

/// The paper's closed forms, Eqs 4, 7, 10-14 and 20-36, in one place. Numbers in brackets are those of
/// core/contact/README.md, equal to the paper's with a C in front; units: MPa, mm, N/mm unless stated.
namespace asperity::closed_forms {

/// Critical displacement e t_c / k_t or e c_c / k_s, Eqs. (C4), (C7); mm.
double critical_displacement(double strength, double stiffness);

/// Area under the tensile curve up to delta_ut, Eq. (C10); N/mm.
double fracture_energy(double t_c, double delta_ct, double delta_ut);

/// delta_ut from G_f, Eq. (C10) solved; mm. May come out below delta_ct where G_f is too small for the hardening part.
double ultimate_tensile_displacement(double t_c, double delta_ct, double g_f);

/// E for plane stress, E / (1 - nu^2) for plane strain, as below Eq. (C34).
double effective_modulus(double youngs_modulus, double poissons_ratio, PlaneCondition plane);

/// Mode-I share of Eq. (C34): K^2 / E~, with K in MPa mm^0.5; N/mm.
double griffith_energy(double toughness, double effective_modulus);

/// Thickness of the cohesive zone, Eqs. (C32), (C35), (C36); mm.
double cohesive_zone_thickness(double g_f, double tensile_strength, double beta);

/// k_t of Eq. (C12) (plane stress) or (C13) (plane strain); MPa/mm.
double tensile_stiffness(const MaterialConfig& material, PlaneCondition plane);

/// k_s of Eqs. (C12), (C13); MPa/mm.
double shear_stiffness(const MaterialConfig& material, PlaneCondition plane);

/// k_s / k_t as Eq. (C14) must read to agree with Eqs. (C12), (C13): (K_IC / K_IIC)^2 / (2 (1 + nu)).
double stiffness_ratio(const MaterialConfig& material);

/// k_s / k_t as the paper prints Eq. (C14), inverted.
double stiffness_ratio_as_printed(const MaterialConfig& material);

/// beta(m, n) of Eq. (C33), m < n.
double beta(int m, int n);

/// alpha of Eq. (C21): the factor that makes the Lennard-Jones potential's depth epsilon.
double lennard_jones_alpha(int m, int n);

/// Lennard-Jones potential, Eq. (C20), at separation x with depth epsilon and zero crossing zeta.
double lennard_jones_potential(double x, double epsilon, double zeta, int m, int n);

/// Force between two molecules, Eq. (C22).
double lennard_jones_force(double x, double epsilon, double zeta, int m, int n);

/// Separation of the largest force, Eq. (C23), in units of zeta.
double peak_force_separation(int m, int n);

/// Largest force, Eq. (C24), in units of epsilon / zeta.
double cohesive_force(int m, int n);

/// Equilibrium separation, Eq. (C25), in units of zeta.
double equilibrium_separation(int m, int n);

/// Bonds per unit volume, Eq. (C26): gamma is the share of bonds that exist, x_0 the equilibrium separation.
double bond_density(double gamma, double x_0);

/// Tensile strength of a material of such bonds, Eq. (C27); p_c is the largest force of one bond.
double bond_strength(double gamma, double p_c, double x_0);

/// Energy to part one bond, Eq. (C28): minus the potential at its equilibrium.
double bond_energy(double epsilon, double zeta, int m, int n);

/// Bonds in a cohesive zone of thickness w and surface a_z, Eq. (C29).
double bonds_in_zone(double gamma, double w, double a_z, double x_0);

/// Griffith's energy of a cohesive zone of thickness w, Eq. (C30).
double bond_fracture_energy(double gamma, double w, double epsilon, double x_0);

/// The same in terms of the largest force p_c instead of epsilon, Eq. (C31).
double bond_fracture_energy_from_force(double gamma, double w, double zeta, double p_c, int m, int n);

/// Both modes' share, Eq. (C34): (K_IC^2 + K_IIC^2) / E~, with K in MPa mm^0.5; N/mm.
double mixed_mode_energy(double mode_i_toughness, double mode_ii_toughness, double effective_modulus);

}  // namespace asperity::closed_forms

namespace asperity {

/// Everything `asperity derive` prints for one plane condition.
struct DerivedParameters {
  double k_t = 0, k_s = 0;                          ///< MPa/mm, Eqs. (C12), (C13)
  double g_f = 0;                                   ///< N/mm, Eq. (C34), mode I
  double g_mixed = 0;                               ///< N/mm, Eq. (C34), both modes
  double w = 0;                                     ///< mm, Eq. (C35)
  double w_sliding = 0;                             ///< mm, Eq. (C36)
  double delta_ct = 0, delta_cs = 0, delta_ut = 0;  ///< mm
  double delta_us = 0;                              ///< mm, Eq. (D9); delta_cs where shear does not soften.
};

/// Closed forms of a config in one plane condition. Values given in the config win over derived ones.
DerivedParameters derive(const RunConfig& config, PlaneCondition plane);

/// Law parameters of a run; throws a config error where G_f is too small to leave room for softening.
LawParameters law_parameters(const RunConfig& config);

}  // namespace asperity
