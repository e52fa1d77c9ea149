#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/contact/law.hpp"

/// The paper's law as printed, Eqs. (C1)-(C9), kept as the reference that the audit reports. It creates energy where a
/// contact passes between closed and open with sliding present; `created_energy` measures it. Departures by name: a
/// Coulomb peak (LawParameters::coulomb) and k_s for the shear component in opening (LawParameters::opening_shear).
namespace asperity::literal_law {

inline constexpr double kE = std::numbers::e;

/// Hardening curve k d exp(-d / critical) of Eqs. (C3), (C6); MPa.
inline double hardening(double k, double d, double critical) { return k * d * std::exp(-d / critical); }

/// Energy under the hardening curve from 0 to d; N/mm.
inline double hardening_energy(double k, double d, double critical) {
  const double x = d / critical;
  return k * critical * critical * (1.0 - (1.0 + x) * std::exp(-x));
}

/// Eq 3 beyond hardening: softening where delta_eff is the largest ever, the secant path below it; returns the stress.
inline double softening(PointState& s, double effective, const LawParameters& p) {
  if (effective >= s.largest) {
    const double first = std::max(s.largest, p.delta_ct);
    const double before = p.t_c * (1.0 - s.damage);
    const double damage = std::min(1.0, (effective - p.delta_ct) / (p.delta_ut - p.delta_ct));
    const double after = p.t_c * (1.0 - damage);
    if (s.largest == 0.0) s.fracture_energy += p.t_c * p.delta_ct * (kE - 2.5);
    s.fracture_energy += 0.5 * std::max(0.0, before * effective - after * first);
    s.damage = damage;
    s.largest = effective;
    return after;
  }
  return p.t_c * (1.0 - s.damage) / s.largest * effective;
}

/// Opening, Eqs. (C2), (C3), (C9).
inline void open_contact(PointState& s, double normal, double shear, const LawParameters& p) {
  const double effective = std::sqrt(normal * normal + shear * shear);
  const bool hardening_stage = s.largest == 0.0 && effective <= p.delta_ct;
  const double stress = hardening_stage ? hardening(p.k_t, effective, p.delta_ct) : softening(s, effective, p);
  const double secant = effective > 0.0 ? stress / effective : p.k_t;
  s.traction_n = secant * normal;
  s.traction_s = p.opening_shear * secant * shear;
  if (s.damage >= 1.0) s.broken = normal >= std::abs(shear) ? BreakMode::tension : BreakMode::shear;
}

/// Friction after breakage with Eq 8's unloading slope k_s.
inline void slide(PointState& s, double shear, double pressure, const LawParameters& p) {
  const double trial = s.friction + p.k_s * (shear - s.shear);
  const double limit = pressure * p.tan_phi;
  const double after = std::clamp(trial, -limit, limit);
  const double mean = s.friction * after > 0.0 ? 0.5 * std::abs(s.friction + after) : std::abs(after);
  s.friction_energy += mean * std::abs(trial - after) / p.k_s;
  s.friction = after;
  s.traction_s = after;
}

/// Closing, Eqs. (C6), (C7): hardening up to the peak, then the drop to friction.
inline void close_contact(PointState& s, double shear, double pressure, const LawParameters& p) {
  const double critical = kE * (p.c_c + p.coulomb * pressure) / p.k_s;
  const double effective = std::abs(shear);
  if (effective <= critical) {
    s.traction_s = std::copysign(hardening(p.k_s, effective, critical), shear);
    return;
  }
  s.broken = BreakMode::shear;
  s.damage = 1.0;
  s.friction = std::copysign(pressure * p.tan_phi, shear);
  s.traction_s = s.friction;
  const double kept = 0.5 * s.friction * s.friction / p.k_s;
  s.fracture_energy += std::max(0.0, hardening_energy(p.k_s, critical, critical) - kept);
}

/// Energy the contact could give back (N/mm). In opening with `opening_shear` other than 1 the traction has no
/// potential; the value is then the one of its normal part and of the reduced shear part.
inline double recoverable_energy(const PointState& s, const LawParameters& p) {
  const double pressure = s.normal < 0.0 ? -p.k_t * s.normal : 0.0;
  const double compression = 0.5 * pressure * pressure / p.k_t;
  if (s.broken != BreakMode::none) return compression + 0.5 * s.friction * s.friction / p.k_s;
  if (s.normal < 0.0) {
    const double critical = kE * (p.c_c + p.coulomb * pressure) / p.k_s;
    return compression + hardening_energy(p.k_s, std::abs(s.shear), critical);
  }
  const double effective = std::sqrt(s.normal * s.normal + s.shear * s.shear);
  if (effective == 0.0) return 0.0;
  const double along = s.largest == 0.0 ? hardening_energy(p.k_t, effective, p.delta_ct)
                                        : 0.5 * p.t_c * (1.0 - s.damage) / s.largest * effective * effective;
  const double sine2 = s.shear * s.shear / (effective * effective);
  return along * (1.0 - sine2 + p.opening_shear * sine2);
}

/// Brings a contact point to a new separation (mm) and its traction up to date.
inline void update(PointState& s, double normal, double shear, const LawParameters& p) {
  const double stored = recoverable_energy(s, p);
  const double spent = s.fracture_energy + s.friction_energy;
  const double before_n = s.traction_n;
  const double before_s = s.traction_s;
  const double pressure = normal < 0.0 ? -p.k_t * normal : 0.0;
  s.traction_n = -pressure;
  if (s.broken != BreakMode::none) {
    slide(s, shear, pressure, p);
  } else if (normal >= 0.0) {
    open_contact(s, normal, shear, p);
  } else {
    close_contact(s, shear, pressure, p);
  }
  const double work =
      0.5 * (before_n + s.traction_n) * (normal - s.normal) + 0.5 * (before_s + s.traction_s) * (shear - s.shear);
  s.normal = normal;
  s.shear = shear;
  s.created_energy += recoverable_energy(s, p) - stored + s.fracture_energy + s.friction_energy - spent - work;
}

}  // namespace asperity::literal_law
