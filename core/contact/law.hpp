#pragma once
#include <cstdint>
#include <initializer_list>

/// Plain data shared by the contact laws. One contact point has a normal separation (mm, opening positive) and a shear
/// displacement (mm); tractions are MPa, energies N/mm (per unit of contact area).
namespace asperity {

enum class BreakMode : std::uint8_t { none = 0, tension = 1, shear = 2 };

/// Microparameters of a contact, in core units; see core/contact/README.md.
struct LawParameters {
  double k_t = 0, k_s = 0;            ///< Initial stiffness in tension and shear, MPa/mm.
  double t_c = 0, c_c = 0;            ///< Tensile strength and cohesion, MPa.
  double tan_phi = 0;                 ///< tan(phi_c).
  double delta_ct = 0, delta_cs = 0;  ///< Critical displacements, Eqs. (C4), (C7), mm.
  double delta_ut = 0;                ///< Ultimate tensile displacement, Eq. (C10), mm.
  double kappa_ut = 0;                ///< delta_ut / delta_ct.
  double kappa_us = 1;                ///< delta_us / delta_cs: end of softening in pure shear; 1: breaks at the peak.
  double inverse_delta_ct = 0;        ///< 1 / delta_ct, 1/mm.
  double coulomb = 0;       ///< Literal law: tan(phi_c) where Eq 6's peak is c_c + sigma_n tan(phi_c), else 0.
  double tan_phi_peak = 0;  ///< Of the intact share's strength, at least tan(phi_c), which it is in the base model.
  double envelope_exponent = 1;  ///< Of that strength and of friction over the pressure, Eq. (D10); 1: straight.
  double friction_share = 1;     ///< tan(phi_c) / tan_phi_peak, where the envelope bends.
  double closure_share = 0;      ///< 1 - k_0 / k_t of normal closing, Eq. (D11); 0: linear.
  double closure_length = 1;     ///< Of the same, mm.
  double opening_shear = 1;      ///< Literal law: factor on Eq 3's shear component, 1 (k_t) or k_s / k_t.
};

/// The law of a contact of another strength, Eq. (C57): strengths and critical displacements times `factor` > 0 at the
/// same stiffness, so that displacements and tractions grow alike and energies with the square.
inline LawParameters scaled(const LawParameters& law, double factor) {
  LawParameters result = law;
  for (double* value : {&result.t_c, &result.c_c, &result.delta_ct, &result.delta_cs, &result.delta_ut}) {
    *value *= factor;
  }
  result.inverse_delta_ct /= factor;
  return result;
}

/// Everything a contact point remembers.
struct PointState {
  double normal = 0, shear = 0;           ///< Separation at the last evaluation.
  double traction_n = 0, traction_s = 0;  ///< Traction then.
  double slip = 0;                        ///< Default law: slip of the intact share.
  double hardening = 0;  ///< Default law: normalised shear displacement x; cohesive-frictional: the largest kappa.
  double integrity_n = 1, integrity_s = 1;  ///< Default law: secant factors g_n, g_s, never growing.
  double friction = 0;                      ///< Shear traction carried by friction (broken share).
  double largest = 0;                       ///< Literal law: delta_max, mm.
  double damage = 0;                        ///< D of Eq. (C5), never falling.
  double fracture_energy = 0;               ///< Spent on breaking the bond, never falling.
  double friction_energy = 0;               ///< Spent in friction, never falling.
  double created_energy = 0;                ///< Literal law: energy the law itself adds (+) or loses (-).
  BreakMode broken = BreakMode::none;
};

}  // namespace asperity
