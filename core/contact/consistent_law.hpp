#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/power.hpp"
#include "core/contact/law.hpp"

/// The default contact law: damage and slip with a free energy, so that no path from the virgin state returns net work.
/// Eqs. (D1)-(D11) and their proof: core/contact/README.md.
namespace asperity::consistent_law {

inline constexpr double kE = std::numbers::e;

/// Secant factor of the virgin curve at normalised separation kappa, Eq. (D5): exp(-kappa), then (1 - D) / (e kappa).
inline double secant_factor(double kappa, double damage) {
  return kappa <= 1.0 ? std::exp(-kappa) : (1.0 - damage) / (kE * kappa);
}

/// Secant factor of shear alone at normalised shear displacement x, Eq. (D6); x times it is the normalised strength of
/// the intact share, Eq. (D3): x exp(-x) up to its peak 1 / e at x = 1, then constant.
inline double shear_secant_factor(double x) { return secant_factor(x, 0.0); }

/// Compressive stress (MPa) at a separation (mm): k_t times the closing, or less while fine cracks close, Eq. (D11).
inline double pressure_at(double normal, const LawParameters& p) {
  if (p.closure_share == 0.0) return std::max(0.0, -p.k_t * normal);
  const double closing = std::max(0.0, -normal);
  return p.k_t * (closing - p.closure_share * closing * p.closure_length / (closing + p.closure_length));
}

/// Work of that stress from rest (N/mm), for a separation below 0.
inline double closing_energy(double normal, const LawParameters& p) {
  if (p.closure_share == 0.0) return 0.5 * p.k_t * normal * normal;
  const double closing = -normal, length = p.closure_length;
  const double spared = p.closure_share * length * (closing - length * std::log1p(closing / length));
  return p.k_t * (0.5 * closing * closing - spared);
}

/// (1 + p tan(phi) / (n c_c))^n of Eq. (D10).
inline double bent_envelope(double pressure, const LawParameters& p) {
  const double bend = p.tan_phi_peak / (p.envelope_exponent * p.c_c);
  return power(1.0 + pressure * bend, p.envelope_exponent);
}

/// Shear strength of the intact share at a pressure (MPa): straight, or a power; Eq. (D10).
inline double shear_strength(double pressure, const LawParameters& p) {
  if (p.envelope_exponent == 1.0) return p.c_c + pressure * p.tan_phi_peak;
  return p.c_c * bent_envelope(pressure, p);
}

/// What friction of the broken share holds at a pressure (MPa), Eqs. (D7), (D10): straight, or as bent as the strength.
inline double friction_limit(double share, double pressure, const LawParameters& p) {
  if (p.envelope_exponent == 1.0) return share * pressure * p.tan_phi;
  return share * (p.c_c * (bent_envelope(pressure, p) - 1.0) * p.friction_share);
}

/// D at kappa; the softening range goes from delta_ut / delta_ct - 1 in pure tension to that of shear, whose slip does
/// not depend on the pressure: `strength` is that of shear, MPa. Shear has none unless it softens, Eq. (D4).
inline double damage_at(double kappa, double kappa_n, double strength, const LawParameters& p) {
  if (kappa <= 1.0) return 0.0;
  const double tension_share = kappa_n * kappa_n / (kappa * kappa);
  const double range =
      (p.kappa_ut - 1.0) * tension_share + (p.kappa_us - 1.0) * (p.c_c / strength) * (1.0 - tension_share);
  return kappa - 1.0 >= range ? 1.0 : (kappa - 1.0) / range;
}

/// Work done by a traction that went from one value to another over a path in its own direction; never negative.
inline double path_work(double from, double to, double path) { return std::max(0.0, 0.5 * (from + to) * path); }

/// Slip of the intact share at its yield curve, Eqs. (D2), (D3), for its shear strength (MPa): exact where that is
/// constant. Returns the slip; `secant` becomes Eq. (D6) at the hardening reached.
inline double slip_intact_share(PointState& s, double shear, double strength, const LawParameters& p, double& secant) {
  const double trial = p.k_s * (shear - s.slip);
  const double curve = kE * strength;
  secant = shear_secant_factor(s.hardening);
  const double yield = curve * s.hardening * secant;
  if (std::abs(trial) <= yield) return 0.0;
  const double x = s.hardening + (std::abs(trial) - yield) / curve;
  s.hardening = x;
  secant = shear_secant_factor(x);
  const double slipped = (trial - std::copysign(curve * x * secant, trial)) / p.k_s;
  s.slip += slipped;
  return slipped;
}

/// Coulomb friction of the broken share, Eq. (D7).
inline void slide_broken_share(PointState& s, double shear, double pressure, const LawParameters& p) {
  const double share = 1.0 - s.integrity_s;
  if (share <= 0.0) return;
  const double stiffness = share * p.k_s;
  const double trial = s.friction + stiffness * (shear - s.shear);
  const double limit = friction_limit(share, pressure, p);
  const double after = std::clamp(trial, -limit, limit);
  s.friction_energy += path_work(s.friction, after, (trial - after) / stiffness);
  s.friction = after;
}

/// A newly broken part of the intact share joins the broken one: it keeps no more than friction can hold, Eq. (D8).
inline void hand_over(PointState& s, double integrity_s, double stress_before, double stress, double limit,
                      double moved, const LawParameters& p) {
  const double part = s.integrity_s - integrity_s;
  const double share = 1.0 - s.integrity_s;
  const double kept = std::clamp(stress, -limit, limit);
  s.fracture_energy += 0.5 * part * std::max(0.0, stress_before * stress - kept * kept) / p.k_s;
  if (share > 0.0) {
    const double gap = kept - s.friction / share;
    s.fracture_energy += 0.5 * part * share / (part + share) * gap * gap / p.k_s;
  }
  s.friction_energy += path_work(0.0, part * kept, moved);
  s.friction += part * kept;
  s.integrity_s = integrity_s;
}

/// How a point breaks at a separation (mm) and hardening: in tension where that has the larger part in kappa, Eq. (D4).
inline BreakMode break_mode(double normal, double hardening, const LawParameters& p) {
  const double kappa_n = std::max(0.0, normal) * p.inverse_delta_ct;
  return kappa_n >= hardening ? BreakMode::tension : BreakMode::shear;
}

/// Shear of the intact share at the present step.
struct IntactShear {
  double strength;       ///< Eq. (D10), MPa.
  double secant = 1;     ///< Eq. (D6) at the hardening reached.
  double stress_before;  ///< Its effective stress before the step, MPa.
};

/// Damage of both modes at the present opening and hardening, Eqs. (D4)-(D6), (D8); `limit` is that of friction, MPa.
inline void damage_contact(PointState& s, double normal, double shear, const IntactShear& intact, double limit,
                           const LawParameters& p) {
  const double opening = std::max(0.0, normal);
  const double kappa_n = opening * p.inverse_delta_ct;
  const double square = kappa_n * kappa_n + s.hardening * s.hardening;
  const double kappa = opening > 0.0 ? std::sqrt(square) : s.hardening;
  s.damage = std::max(s.damage, damage_at(kappa, kappa_n, intact.strength, p));
  const double factor = opening > 0.0 ? secant_factor(kappa, s.damage) : (1.0 - s.damage) * intact.secant;
  const double g_n = std::min(s.integrity_n, factor);
  const double g_s = std::min(s.integrity_s, opening > 0.0 ? factor / intact.secant : 1.0 - s.damage);
  s.fracture_energy += 0.5 * p.k_t * std::max(0.0, s.normal) * opening * (s.integrity_n - g_n);
  s.integrity_n = g_n;
  if (g_s < s.integrity_s) {
    hand_over(s, g_s, intact.stress_before, p.k_s * (shear - s.slip), limit, shear - s.shear, p);
  }
  if (s.damage >= 1.0) s.broken = break_mode(normal, s.hardening, p);
}

/// Traction at the present separation, Eqs. (D1), (D7).
inline void set_traction(PointState& s, const LawParameters& p) {
  const double pressure = pressure_at(s.normal, p);
  s.traction_n = s.integrity_n * p.k_t * std::max(0.0, s.normal) - pressure;
  s.traction_s = s.integrity_s * p.k_s * (s.shear - s.slip) + s.friction;
}

/// Brings a contact point to a new separation (mm) and its traction up to date.
inline void update(PointState& s, double normal, double shear, const LawParameters& p) {
  const double pressure = pressure_at(normal, p);
  slide_broken_share(s, shear, pressure, p);
  if (s.broken == BreakMode::none) {
    IntactShear intact{shear_strength(pressure, p), 1.0, p.k_s * (s.shear - s.slip)};
    const double traction_before = s.integrity_s * intact.stress_before;
    const double slipped = slip_intact_share(s, shear, intact.strength, p, intact.secant);
    damage_contact(s, normal, shear, intact, friction_limit(1.0, pressure, p), p);
    s.fracture_energy += path_work(traction_before, s.integrity_s * p.k_s * (shear - s.slip), slipped);
  }
  s.normal = normal;
  s.shear = shear;
  set_traction(s, p);
}

/// Recoverable energy of a contact point (N/mm), Eq. (D1).
inline double recoverable_energy(const PointState& s, const LawParameters& p) {
  const double elastic = s.shear - s.slip;
  const double normal =
      s.normal < 0.0 ? closing_energy(s.normal, p) : 0.5 * s.integrity_n * p.k_t * s.normal * s.normal;
  const double share = 1.0 - s.integrity_s;
  const double friction = share > 0.0 ? 0.5 * s.friction * s.friction / (share * p.k_s) : 0.0;
  return normal + 0.5 * s.integrity_s * p.k_s * elastic * elastic + friction;
}

}  // namespace asperity::consistent_law
