// The default law of contact points in vector registers, as consistent_law.hpp has it for one point. Include once in a
// kernel file, after foreach_target.h; the guard lets it through once for each instruction set.
#if defined(ASPERITY_CONTACT_LAW_SIMD_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ASPERITY_CONTACT_LAW_SIMD_INL
#undef ASPERITY_CONTACT_LAW_SIMD_INL
#else
#define ASPERITY_CONTACT_LAW_SIMD_INL
#endif

#include "core/base/simd_points.inl.hpp"
#include "core/base/simd_power.inl.hpp"
#include "core/contact/consistent_law.hpp"

HWY_BEFORE_NAMESPACE();
namespace asperity::HWY_NAMESPACE {

using hn::Add;
using hn::AllFalse;
using hn::And;
using hn::IfThenElse;
using hn::IfThenElseZero;
using hn::Max;
using hn::Min;
using hn::Mul;
using hn::Neg;
using hn::Sub;
using hn::Zero;
using Lanes = hn::Mask<Doubles>;

constexpr Doubles kDoubles;

HWY_INLINE Real set(double value) { return hn::Set(kDoubles, value); }
HWY_INLINE bool any(Lanes lanes) { return !AllFalse(kDoubles, lanes); }
HWY_INLINE Real clamp(Real value, Real limit) { return Max(Neg(limit), Min(value, limit)); }

/// What goes with a contact's strength, Eq. (C57).
struct Strengths {
  Real cohesion;  ///< e c_c
  Real c_c, inverse_delta_ct;
  Real bend;  ///< tan(phi) / (n c_c) of Eq. (D10).
};

/// LawParameters in every lane, with the products and inverses the kernel needs.
struct Law {
  Real k_t, k_s, inverse_k_s, half_k_t, half_inverse_k_s;
  Strengths strengths;  ///< At factor 1.
  Real slope;           ///< e tan(phi): with the pressure and e c_c, the factor of the normalised curve.
  Real tan_phi, tan_phi_peak, range, shear_range;
  // Of the varied kernel alone: Eqs. (D10), (D11).
  bool bends, closes;
  Real exponent, friction_share, closure_share, closure_length;
  explicit Law(const LawParameters& p)
      : k_t(set(p.k_t)),
        k_s(set(p.k_s)),
        inverse_k_s(set(1.0 / p.k_s)),
        half_k_t(set(0.5 * p.k_t)),
        half_inverse_k_s(set(0.5 / p.k_s)),
        strengths{set(consistent_law::kE * p.c_c), set(p.c_c), set(p.inverse_delta_ct),
                  set(p.tan_phi_peak / (p.envelope_exponent * p.c_c))},
        slope(set(consistent_law::kE * p.tan_phi_peak)),
        tan_phi(set(p.tan_phi)),
        tan_phi_peak(set(p.tan_phi_peak)),
        range(set(p.kappa_ut - 1.0)),
        shear_range(set(p.kappa_us - 1.0)),
        bends(p.envelope_exponent != 1.0),
        closes(p.closure_share != 0.0),
        exponent(set(p.envelope_exponent)),
        friction_share(set(p.friction_share)),
        closure_share(set(p.closure_share)),
        closure_length(set(p.closure_length)) {}
};

/// scaled() of every lane by its factor.
HWY_INLINE Strengths scaled(const Strengths& s, Real factor) {
  return {Mul(s.cohesion, factor), Mul(s.c_c, factor), hn::Div(s.inverse_delta_ct, factor), hn::Div(s.bend, factor)};
}

/// What the contacts of a run have: the base law, every contact the same, or strengths, a curved envelope or a closure
/// of their own, Eqs. (C57), (D10), (D11). The base kernel pays nothing for the varied one.
enum class Contacts { base, varied };

/// pressure_at() of the scalar law.
template <Contacts kKind>
HWY_INLINE Real pressure_at(Real normal, const Law& p) {
  if (kKind == Contacts::varied && p.closes) {
    const Real closing = Max(Zero(kDoubles), Neg(normal));
    const Real spared = hn::Div(Mul(Mul(p.closure_share, closing), p.closure_length), Add(closing, p.closure_length));
    return Mul(p.k_t, Sub(closing, spared));
  }
  return Max(Zero(kDoubles), Neg(Mul(p.k_t, normal)));
}

/// Pressure, shear strength S of the intact share under it, and e S, the factor of the normalised curve; Eqs. (D2),
/// (D10), (D11). `friction` is what the broken share holds where the envelope bends.
struct Pressed {
  Real pressure, strength, curve, friction;
};

template <Contacts kKind>
HWY_INLINE Pressed press(Real normal, const Strengths& s, const Law& p) {
  const Real pressure = pressure_at<kKind>(normal, p);
  if (kKind == Contacts::varied && p.bends) {
    const Real bent = power(Add(set(1.0), Mul(pressure, s.bend)), p.exponent);
    const Real strength = Mul(s.c_c, bent), friction = Mul(Mul(s.c_c, Sub(bent, set(1.0))), p.friction_share);
    return {pressure, strength, Mul(set(consistent_law::kE), strength), friction};
  }
  return {pressure, Add(s.c_c, Mul(pressure, p.tan_phi_peak)), Add(s.cohesion, Mul(pressure, p.slope)), Zero(kDoubles)};
}

/// friction_limit() of the scalar law.
HWY_INLINE Real friction_limit(Real share, const Pressed& now, const Law& p) {
  if (p.bends) return Mul(share, now.friction);
  return Mul(Mul(share, now.pressure), p.tan_phi);
}

/// S of Eqs. (D5), (D6) with (1 - D) for `intact`.
HWY_INLINE Real secant_factor(Real kappa, Real intact) {
  const Real one = set(1.0);
  const Real hardening = unit_exp(Min(kappa, one));
  const Lanes beyond = hn::Gt(kappa, one);
  if (HWY_LIKELY(!any(beyond))) return hardening;
  return IfThenElse(beyond, hn::Div(intact, Mul(set(consistent_law::kE), kappa)), hardening);
}

/// path_work() of the scalar law.
HWY_INLINE Real path_work(Real from, Real to, Real path) {
  return Max(Zero(kDoubles), Mul(Mul(set(0.5), Add(from, to)), path));
}

/// One row of points in registers.
struct State {
  Real normal, shear, slip, hardening, integrity_n, integrity_s, friction, damage, fracture_energy;
};

struct Traction {
  Real n, s;
};

/// What one update of eight points leaves behind besides their state.
struct Outcome {
  Traction traction;
  Real friction_energy;  ///< Spent now.
  Lanes breaks;
  // Which rows have changed in any lane: the others are not written back, which spares a large model's memory.
  bool yields = false, rubs = false, weakens = false, softens = false;
};

/// Eq. (D7).
HWY_INLINE void slide_broken_share(State& s, Real shear, const Pressed& now, const Law& p, Outcome& out) {
  const Real share = Sub(set(1.0), s.integrity_s);
  const Lanes acts = hn::Gt(share, Zero(kDoubles));
  if (!any(acts)) return;
  out.rubs = true;
  const Real stiffness = Mul(share, p.k_s);
  const Real trial = Add(s.friction, Mul(stiffness, Sub(shear, s.shear)));
  const Real after = clamp(trial, friction_limit(share, now, p));
  const Lanes slides = And(acts, hn::Ne(trial, after));
  if (any(slides)) {
    const Real path = IfThenElseZero(slides, hn::Div(Sub(trial, after), stiffness));
    out.friction_energy = Add(out.friction_energy, path_work(s.friction, after, path));
  }
  s.friction = IfThenElse(acts, after, s.friction);
}

/// Eq. (D8).
HWY_INLINE void hand_over(State& s, Real integrity_s, Real stress_before, Real stress, Real limit, Real moved,
                          const Law& p, Outcome& out) {
  const Real part = Sub(s.integrity_s, integrity_s), share = Sub(set(1.0), s.integrity_s);
  if (!any(hn::Gt(part, Zero(kDoubles)))) return;
  out.rubs = true;
  const Real kept = clamp(stress, limit);
  const Real lost = Max(Zero(kDoubles), Sub(Mul(stress_before, stress), Mul(kept, kept)));
  s.fracture_energy = Add(s.fracture_energy, Mul(Mul(p.half_inverse_k_s, part), lost));
  const Lanes shared = hn::Gt(share, Zero(kDoubles));
  if (any(shared)) {
    // part share / (part + share) (kept - friction / share)^2 with one division
    const Real gap = Sub(Mul(kept, share), s.friction);
    const Real equalised = hn::Div(Mul(Mul(p.half_inverse_k_s, part), Mul(gap, gap)), Mul(share, Add(part, share)));
    s.fracture_energy = Add(s.fracture_energy, IfThenElseZero(shared, equalised));
  }
  const Real taken = Mul(part, kept);
  out.friction_energy = Add(out.friction_energy, path_work(Zero(kDoubles), taken, moved));
  s.friction = Add(s.friction, taken);
  s.integrity_s = integrity_s;
}

/// consistent_law::update() of unbroken points; `now` is what they are pressed with at the present separation.
HWY_INLINE Outcome update_points(State& s, Real normal, Real shear, const Pressed& now, const Strengths& strengths,
                                 const Law& p) {
  const Real zero = Zero(kDoubles), one = set(1.0);
  const Real pressure = now.pressure;
  Outcome out{{zero, zero}, zero, hn::Lt(zero, zero)};
  slide_broken_share(s, shear, now, p, out);

  // Eqs. (D2), (D3)
  const Real stress_before = Mul(p.k_s, Sub(s.shear, s.slip));
  const Real traction_before = Mul(s.integrity_s, stress_before);
  const Real trial = Mul(p.k_s, Sub(shear, s.slip));
  Real shear_secant = secant_factor(s.hardening, one);
  const Real yield = Mul(Mul(now.curve, s.hardening), shear_secant);
  const Real excess = Sub(hn::Abs(trial), yield);
  const Lanes yields = hn::Gt(excess, zero);
  Real slipped = zero;
  out.yields = any(yields);
  if (out.yields) {
    s.hardening = IfThenElse(yields, Add(s.hardening, hn::Div(excess, now.curve)), s.hardening);
    shear_secant = secant_factor(s.hardening, one);
    const Real held = hn::CopySign(Mul(Mul(now.curve, s.hardening), shear_secant), trial);
    slipped = IfThenElseZero(yields, Mul(Sub(trial, held), p.inverse_k_s));
    s.slip = Add(s.slip, slipped);
  }

  // Eqs. (D4)-(D6)
  const Real opening = Max(zero, normal);
  const Lanes open = hn::Gt(opening, zero);
  const Real stress = Mul(p.k_s, Sub(shear, s.slip));
  const bool any_open = any(open);
  Real kappa = s.hardening, kappa_n2 = zero;
  if (any_open) {
    const Real kappa_n = Mul(opening, strengths.inverse_delta_ct);
    kappa_n2 = Mul(kappa_n, kappa_n);
    kappa = IfThenElse(open, hn::Sqrt(Add(kappa_n2, Mul(s.hardening, s.hardening))), kappa);
  }
  const Lanes softens = hn::Gt(kappa, one);
  out.softens = any(softens);
  if (out.softens) {
    const Real beyond = Sub(kappa, one), tension_share = hn::Div(kappa_n2, Mul(kappa, kappa));
    const Real shear_range = Mul(p.shear_range, hn::Div(strengths.c_c, now.strength));
    const Real range = Add(Mul(p.range, tension_share), Mul(shear_range, Sub(one, tension_share)));
    const Real present = IfThenElse(hn::Ge(beyond, range), one, hn::Div(beyond, range));
    s.damage = Max(s.damage, IfThenElseZero(softens, present));
  }
  const Real intact = Sub(one, s.damage);
  Real g_s = intact, factor = Mul(intact, shear_secant);
  if (any_open) {
    const Real mixed = secant_factor(kappa, intact);
    factor = IfThenElse(open, mixed, factor);
    g_s = IfThenElse(open, hn::Div(mixed, shear_secant), g_s);
  }
  const Real g_n = Min(s.integrity_n, factor);
  out.weakens = any(hn::Lt(g_n, s.integrity_n));
  if (any_open) {
    const Real released = Mul(Mul(Max(zero, s.normal), opening), Sub(s.integrity_n, g_n));
    s.fracture_energy = Add(s.fracture_energy, Mul(p.half_k_t, released));
  }
  s.integrity_n = g_n;
  const Real limit = p.bends ? now.friction : Mul(pressure, p.tan_phi);
  hand_over(s, Min(s.integrity_s, g_s), stress_before, stress, limit, Sub(shear, s.shear), p, out);
  s.fracture_energy = Add(s.fracture_energy, path_work(traction_before, Mul(s.integrity_s, stress), slipped));

  out.traction.n = Sub(Mul(Mul(s.integrity_n, p.k_t), opening), pressure);
  out.traction.s = Add(Mul(s.integrity_s, stress), s.friction);
  out.breaks = hn::Ge(s.damage, one);
  s.normal = normal;
  s.shear = shear;
  return out;
}

}  // namespace asperity::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
