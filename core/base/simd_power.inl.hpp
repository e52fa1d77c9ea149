// power() of every lane, for Highway kernels. Include after simd_points.inl.hpp.
#if defined(ASPERITY_BASE_SIMD_POWER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ASPERITY_BASE_SIMD_POWER_INL
#undef ASPERITY_BASE_SIMD_POWER_INL
#else
#define ASPERITY_BASE_SIMD_POWER_INL
#endif

#include "core/base/power.hpp"
#include "core/base/simd_points.inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace asperity::HWY_NAMESPACE {

/// log2_of() of every lane, bit for bit.
HWY_INLINE Real log2_of(Real z) {
  const Doubles d;
  const hn::RebindToUnsigned<Doubles> u;
  const auto term = [&](int i, Real x) { return hn::Add(hn::Set(d, kLog2[i]), hn::Mul(hn::Set(d, kLog2[i + 1]), x)); };
  const Real one = hn::Set(d, 1.0), integer = hn::Set(d, kIntegerBits);
  const auto bits = hn::BitCast(u, z);
  const auto exponent = hn::ShiftRight<kMantissaBits>(hn::Sub(bits, hn::Set(u, kRootHalfBits)));
  const Real whole = hn::Sub(hn::BitCast(d, hn::Or(exponent, hn::BitCast(u, integer))), integer);
  const Real m = hn::BitCast(d, hn::Sub(bits, hn::ShiftLeft<kMantissaBits>(exponent)));
  const Real s = hn::Div(hn::Sub(m, one), hn::Add(m, one));
  const Real s2 = hn::Mul(s, s), s4 = hn::Mul(s2, s2), s8 = hn::Mul(s4, s4);
  const Real low = hn::Add(term(0, s2), hn::Mul(term(2, s2), s4));
  const Real high = hn::Add(term(4, s2), hn::Mul(hn::Set(d, kLog2[6]), s4));
  return hn::Add(whole, hn::Mul(s, hn::Add(low, hn::Mul(high, s8))));
}

/// exp2_of() of every lane, bit for bit.
HWY_INLINE Real exp2_of(Real t) {
  const Doubles d;
  const hn::RebindToUnsigned<Doubles> u;
  const auto term = [&](int i, Real x) { return hn::Add(hn::Set(d, kExp2[i]), hn::Mul(hn::Set(d, kExp2[i + 1]), x)); };
  const Real shift = hn::Set(d, kRoundingBits), rounded = hn::Add(t, shift);
  const Real f = hn::Sub(t, hn::Sub(rounded, shift)), f2 = hn::Mul(f, f), f4 = hn::Mul(f2, f2);
  const auto four = [&](int i) { return hn::Add(term(i, f), hn::Mul(term(i + 2, f), f2)); };
  const Real high = hn::Add(term(8, f), hn::Mul(hn::Set(d, kExp2[10]), f2));
  const Real mantissa = hn::Add(four(0), hn::Mul(hn::Add(four(4), hn::Mul(high, f4)), f4));
  return hn::BitCast(d, hn::Add(hn::BitCast(u, mantissa), hn::ShiftLeft<kMantissaBits>(hn::BitCast(u, rounded))));
}

/// power() of every lane, bit for bit.
HWY_INLINE Real power(Real base, Real exponent) { return exp2_of(hn::Mul(exponent, log2_of(base))); }

}  // namespace asperity::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
