// Loads and stores of points (x, y side by side) into registers of x and of y, for Highway kernels. Include once in
// every kernel file, after foreach_target.h; the guard lets it through once for each instruction set.
#if defined(ASPERITY_BASE_SIMD_POINTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ASPERITY_BASE_SIMD_POINTS_INL
#undef ASPERITY_BASE_SIMD_POINTS_INL
#else
#define ASPERITY_BASE_SIMD_POINTS_INL
#endif

#include <hwy/highway.h>

#include "core/base/unit_exp.hpp"

HWY_BEFORE_NAMESPACE();
namespace asperity::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// As many doubles as a register holds, at most eight.
using Doubles = hn::CappedTag<double, 8>;
using Real = hn::Vec<Doubles>;
inline constexpr std::size_t kLanes = hn::MaxLanes(Doubles());

/// Points in neighbouring lanes.
struct Points {
  Real x, y;
};

#if HWY_TARGET == HWY_SCALAR
/// Points at place(lane), a pointer to x followed by y.
template <class Place>
HWY_INLINE Points load_points(const Place& place) {
  const Doubles d;
  return {hn::Set(d, place(0)[0]), hn::Set(d, place(0)[1])};
}

template <class Place>
HWY_INLINE void store_points(const Points& p, const Place& place) {
  place(0)[0] = hn::GetLane(p.x);
  place(0)[1] = hn::GetLane(p.y);
}
#else
/// (x, y) of lanes first, first + 2, ... side by side.
template <class D, class Place>
HWY_INLINE hn::Vec<D> load_pairs(D d, const Place& place, std::size_t first) {
  if constexpr (hn::MaxLanes(D()) == 2) {
    return hn::LoadU(d, place(first));
  } else {
    const hn::Half<D> half;
    return hn::Combine(d, load_pairs(half, place, first + hn::MaxLanes(D()) / 2), load_pairs(half, place, first));
  }
}

template <class D, class Place>
HWY_INLINE void store_pairs(D d, hn::Vec<D> pairs, const Place& place, std::size_t first) {
  if constexpr (hn::MaxLanes(D()) == 2) {
    hn::StoreU(pairs, d, place(first));
  } else {
    const hn::Half<D> half;
    store_pairs(half, hn::LowerHalf(half, pairs), place, first);
    store_pairs(half, hn::UpperHalf(half, pairs), place, first + hn::MaxLanes(D()) / 2);
  }
}

/// Points at place(lane), a pointer to x followed by y: one 128-bit load each, then shuffles, where gathers of single
/// numbers would take twice as many loads.
template <class Place>
HWY_INLINE Points load_points(const Place& place) {
  const Doubles d;
  const Real even = load_pairs(d, place, 0), odd = load_pairs(d, place, 1);
  return {hn::InterleaveLower(d, even, odd), hn::InterleaveUpper(d, even, odd)};
}

template <class Place>
HWY_INLINE void store_points(const Points& p, const Place& place) {
  const Doubles d;
  store_pairs(d, hn::InterleaveLower(d, p.x, p.y), place, 0);
  store_pairs(d, hn::InterleaveUpper(d, p.x, p.y), place, 1);
}
#endif

HWY_INLINE Points operator+(const Points& a, const Points& b) { return {hn::Add(a.x, b.x), hn::Add(a.y, b.y)}; }
HWY_INLINE Points operator-(const Points& a, const Points& b) { return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y)}; }
HWY_INLINE Points operator*(Real s, const Points& a) { return {hn::Mul(s, a.x), hn::Mul(s, a.y)}; }
HWY_INLINE Real dot(const Points& a, const Points& b) { return hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)); }

/// unit_exp() of every lane, bit for bit. Products and sums stay apart: a fused one would round otherwise.
HWY_INLINE Real unit_exp(Real x) {
  const Doubles d;
  const auto term = [&](int i, Real t) {
    return hn::Add(hn::Set(d, kUnitExp[i]), hn::Mul(hn::Set(d, kUnitExp[i + 1]), t));
  };
  const Real t = hn::Sub(x, hn::Set(d, 0.5)), t2 = hn::Mul(t, t), t4 = hn::Mul(t2, t2);
  const auto four = [&](int i) { return hn::Add(term(i, t), hn::Mul(term(i + 2, t), t2)); };
  return hn::Add(four(0), hn::Mul(hn::Add(four(4), hn::Mul(four(8), t4)), t4));
}

}  // namespace asperity::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
