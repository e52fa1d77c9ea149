#pragma once
#include <array>

namespace asperity {

/// Coefficients of t^0 ... t^11, t = x - 1/2, of the polynomial that interpolates exp(-x) at the twelve Chebyshev nodes
/// of [0, 1]. Its relative error there is 4e-16, with the rounding of its evaluation below 8e-16.
inline constexpr std::array<double, 12> kUnitExp{
    0x1.368b2fc6f9609p-1,  -0x1.368b2fc6f960ap-1,  0x1.368b2fc6f991cp-2,  -0x1.9e0eea5ea1e54p-4,
    0x1.9e0eea5e12813p-6,  -0x1.4b3f21e52230dp-8,  0x1.b9a983b8c979fp-11, -0x1.f8c1ba7afa4c4p-14,
    0x1.f8bf6c6310bb4p-17, -0x1.c0aac8cfe252bp-20, 0x1.68fb99593cb3bp-23, -0x1.064dc229ecb9fp-26};

/// exp(-x) for x in [0, 1], in Estrin's order, which the vector kernels share: the same bits there.
inline double unit_exp(double x) {
  const std::array<double, 12>& c = kUnitExp;
  const double t = x - 0.5, t2 = t * t, t4 = t2 * t2;
  const double low = (c[0] + c[1] * t) + (c[2] + c[3] * t) * t2;
  const double middle = (c[4] + c[5] * t) + (c[6] + c[7] * t) * t2;
  const double high = (c[8] + c[9] * t) + (c[10] + c[11] * t) * t2;
  return low + (middle + high * t4) * t4;
}

}  // namespace asperity
