#pragma once
#include <array>
#include <bit>
#include <cstdint>

/// A power that vector kernels share bit for bit: std::pow rounds as each library likes, and has no vector form. It is
/// 2^(exponent log2(base)), with log2 and 2^x by polynomials after exact reductions.
namespace asperity {

/// Coefficients of s, s^3, ... s^13, s = (m - 1) / (m + 1), of the polynomial for log2(m) = (2 / ln 2) atanh(s): it
/// interpolates log2(m) / s at seven Chebyshev nodes of s^2 for m from sqrt(1/2) to sqrt(2). Its relative error is
/// 2e-16.
inline constexpr std::array<double, 7> kLog2{0x1.71547652b82ffp+1, 0x1.ec709dc39ca40p-1, 0x1.2776c516a083cp-1,
                                             0x1.a61756810b0f8p-2, 0x1.484fa9965bc9cp-2, 0x1.0bb80a92c80ccp-2,
                                             0x1.f17dfd13ae0efp-3};

/// Coefficients of f^0 ... f^10 of the polynomial that interpolates 2^f at eleven Chebyshev nodes of [-1/2, 1/2]. Its
/// relative error there is 3e-16.
inline constexpr std::array<double, 11> kExp2{0x1.0000000000000p+0,  0x1.62e42fefa3a19p-1,  0x1.ebfbdff82c598p-3,
                                              0x1.c6b08d703ce49p-5,  0x1.3b2ab6fba1ddap-7,  0x1.5d87fe9d7a584p-10,
                                              0x1.430913096fd9fp-13, 0x1.ffcb54062e698p-17, 0x1.62bfd47773353p-20,
                                              0x1.b675bca4eeebbp-24, 0x1.e6063f7217bc6p-28};

inline constexpr int kMantissaBits = 52;
inline constexpr std::uint64_t kRootHalfBits = 0x3fe6a09e667f3bcd;  ///< Of sqrt(1/2).
inline constexpr double kIntegerBits = 0x1p52;  ///< Its mantissa holds an integer that is or-ed into it.
inline constexpr double kRoundingBits =
    0x1.8p52;  ///< Added to a number, it leaves the nearest integer in the mantissa.

/// log2(z) for finite z >= 1: exponent and mantissa by their bits, the mantissa between sqrt(1/2) and sqrt(2).
inline double log2_of(double z) {
  const std::array<double, 7>& c = kLog2;
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(z);
  const std::uint64_t exponent = (bits - kRootHalfBits) >> kMantissaBits;
  const double whole = std::bit_cast<double>(exponent | std::bit_cast<std::uint64_t>(kIntegerBits)) - kIntegerBits;
  const double m = std::bit_cast<double>(bits - (exponent << kMantissaBits));
  const double s = (m - 1.0) / (m + 1.0), s2 = s * s, s4 = s2 * s2, s8 = s4 * s4;
  const double low = (c[0] + c[1] * s2) + (c[2] + c[3] * s2) * s4;
  return whole + s * (low + ((c[4] + c[5] * s2) + c[6] * s4) * s8);
}

/// 2^t for t from 0 to 1000.
inline double exp2_of(double t) {
  const std::array<double, 11>& c = kExp2;
  const double rounded = t + kRoundingBits;
  const double f = t - (rounded - kRoundingBits), f2 = f * f, f4 = f2 * f2;
  const double low = (c[0] + c[1] * f) + (c[2] + c[3] * f) * f2;
  const double middle = (c[4] + c[5] * f) + (c[6] + c[7] * f) * f2;
  const double high = (c[8] + c[9] * f) + c[10] * f2;
  const double mantissa = low + (middle + high * f4) * f4;
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(mantissa) +
                               (std::bit_cast<std::uint64_t>(rounded) << kMantissaBits));
}

/// base^exponent for base >= 1 and exponent > 0, to a few units of 1e-16 times 1 + log2 of the result; below 2^1000.
inline double power(double base, double exponent) { return exp2_of(exponent * log2_of(base)); }

}  // namespace asperity
