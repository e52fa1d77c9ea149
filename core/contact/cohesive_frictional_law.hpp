#pragma once
#include <algorithm>
#include <cmath>

#include "core/contact/consistent_law.hpp"
#include "core/contact/law.hpp"

/// The second form of the default law: cohesion on the intact share of a contact, Coulomb friction on the damaged one,
/// one damage variable for both modes (Alfano & Sacco 2006, Int. J. Numer. Meth. Engng 68). Eqs. (A1)-(A8) and their
/// proof: core/contact/README.md. It keeps its memory in the members of the first form: `integrity_n` and `integrity_s`
/// are both g, `hardening` is the largest kappa, and `slip` stays 0, so that traction and recoverable energy of a point
/// are consistent_law::set_traction() and consistent_law::recoverable_energy().
namespace asperity::cohesive_frictional_law {

/// Normalised separations of the two modes, Eq. (A2); the shear part does not depend on the pressure.
struct Separation {
  double opening = 0, shear = 0;
  double square() const { return opening * opening + shear * shear; }
};

inline Separation separation(double normal, double shear, const LawParameters& p) {
  return {std::max(0.0, normal) * p.inverse_delta_ct, std::abs(shear) / p.delta_cs};
}

/// Energy given up by a part of the intact share that breaks while its stress goes from one value to another (MPa) of
/// which friction keeps `kept`, over a step; Eq. (A7) for trapezoids, never negative.
inline double released_energy(double part, double before, double after, double kept, double k_s) {
  return 0.5 * part * std::max(0.0, (after - kept) * (before + kept)) / k_s;
}

/// What is lost where a part that keeps a stress (MPa) joins the damaged share: both then have the mean elastic slip.
inline double mixing_energy(const PointState& s, double part, double kept, double k_s) {
  const double share = 1.0 - s.integrity_s;
  if (share <= 0.0) return 0.0;
  const double gap = kept - s.friction / share;
  return 0.5 * part * share / (part + share) * gap * gap / k_s;
}

/// A part of the intact share breaks and joins the damaged one, Eqs. (A6), (A7); `limit` is p tan(phi_c).
inline void join_damaged_share(PointState& s, double part, double shear, double limit, const LawParameters& p) {
  const double before = p.k_s * s.shear, after = p.k_s * shear;
  const double kept = std::clamp(after, -limit, limit);
  s.fracture_energy += released_energy(part, before, after, kept, p.k_s) + mixing_energy(s, part, kept, p.k_s);
  s.friction += part * kept;
}

/// Damage where kappa passes all it has been, Eqs. (A3), (A4); `limit` is p tan(phi_c), MPa.
inline void damage_contact(PointState& s, double normal, double shear, double limit, const LawParameters& p) {
  const Separation size = separation(normal, shear, p);
  if (size.square() <= s.hardening * s.hardening) return;
  const double kappa = std::sqrt(size.square());
  s.hardening = kappa;
  s.damage = std::max(s.damage, consistent_law::damage_at(kappa, size.opening, p.c_c, p));
  const double g = std::min(s.integrity_s, consistent_law::secant_factor(kappa, s.damage));
  const double part = s.integrity_s - g;
  s.fracture_energy += 0.5 * part * p.k_t * std::max(0.0, s.normal) * std::max(0.0, normal);
  join_damaged_share(s, part, shear, limit, p);
  s.integrity_n = s.integrity_s = g;
  if (s.damage >= 1.0) s.broken = size.opening >= size.shear ? BreakMode::tension : BreakMode::shear;
}

/// Brings a contact point to a new separation (mm) and its traction up to date.
inline void update(PointState& s, double normal, double shear, const LawParameters& p) {
  const double pressure = std::max(0.0, -p.k_t * normal);
  consistent_law::slide_broken_share(s, shear, pressure, p);
  if (s.broken == BreakMode::none) damage_contact(s, normal, shear, pressure * p.tan_phi, p);
  s.normal = normal;
  s.shear = shear;
  consistent_law::set_traction(s, p);
}

}  // namespace asperity::cohesive_frictional_law
