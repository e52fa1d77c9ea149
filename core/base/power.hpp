#pragma once
#include <array>
#include <bit>
#include <cstdint>

/// A power that vector kernels share bit for bit: std::pow rounds as each library likes, and has no vector form. It is
/// 2^(exponent log2(base)), with log2 and 2^x by series after exact reductions.
namespace asperity {

/// Coefficients of s, s^3, ... s^19, s = (m - 1) / (m + 1): the series of log2(m) = (2 / ln 2) atanh(s). For m between
/// sqrt(1/2) and sqrt(2) what is left out is below 3e-17 of the value.
inline constexpr std::array<double, 10> kLog2{
    0x1.71547652b82fep+1, 0x1.ec709dc3a03fdp-1, 0x1.2776c50ef9bfep-1, 0x1.a61762a7aded9p-2, 0x1.484b13d7c02a9p-2,
    0x1.0c9a84994022dp-2, 0x1.c68f568d31760p-3, 0x1.89f3b1694cffep-3, 0x1.5b9ac9b743f0dp-3, 0x1.3703c1f4d0ffep-3};

/// Coefficients of f^0 ... f^12 of 2^f, (ln 2)^i / i!. For |f| <= 1/2 what is left out is below 3e-16 of the value.
inline constexpr std::array<double, 13> kExp2{
    0x1.0000000000000p+0,  0x1.62e42fefa39efp-1,  0x1.ebfbdff82c58fp-3,  0x1.c6b08d704a0c0p-5,  0x1.3b2ab6fba4e77p-7,
    0x1.5d87fe78a6731p-10, 0x1.430912f86c787p-13, 0x1.ffcbfc588b0c7p-17, 0x1.62c0223a5c824p-20, 0x1.b5253d395e7c4p-24,
    0x1.e4cf5158b8ecap-28, 0x1.e8cac7351bb25p-32, 0x1.c3bd650fc2986p-36};

inline constexpr int kMantissaBits = 52;
inline constexpr std::uint64_t kRootHalfBits = 0x3fe6a09e667f3bcd;  ///< Of sqrt(1/2).
inline constexpr double kIntegerBits = 0x1p52;    ///< Its mantissa holds an integer that is or-ed into it.
inline constexpr double kRoundingBits = 0x1.8p52;  ///< Added to a number, it leaves the nearest integer in the mantissa.

/// log2(z) for finite z >= 1: exponent and mantissa by their bits, the mantissa between sqrt(1/2) and sqrt(2).
inline double log2_of(double z) {
  const std::array<double, 10>& c = kLog2;
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(z);
  const std::uint64_t exponent = (bits - kRootHalfBits) >> kMantissaBits;
  const double whole = std::bit_cast<double>(exponent | std::bit_cast<std::uint64_t>(kIntegerBits)) - kIntegerBits;
  const double m = std::bit_cast<double>(bits - (exponent << kMantissaBits));
  const double s = (m - 1.0) / (m + 1.0), s2 = s * s, s4 = s2 * s2, s8 = s4 * s4;
  const double low = (c[0] + c[1] * s2) + (c[2] + c[3] * s2) * s4;
  const double middle = (c[4] + c[5] * s2) + (c[6] + c[7] * s2) * s4;
  return whole + s * (low + (middle + (c[8] + c[9] * s2) * s8) * s8);
}

/// 2^t for t from 0 to 1000.
inline double exp2_of(double t) {
  const std::array<double, 13>& c = kExp2;
  const double rounded = t + kRoundingBits;
  const double f = t - (rounded - kRoundingBits), f2 = f * f, f4 = f2 * f2;
  const double low = (c[0] + c[1] * f) + (c[2] + c[3] * f) * f2;
  const double middle = (c[4] + c[5] * f) + (c[6] + c[7] * f) * f2;
  const double high = (c[8] + c[9] * f) + (c[10] + c[11] * f) * f2 + c[12] * f4;
  const double mantissa = low + (middle + high * f4) * f4;
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(mantissa) +
                               (std::bit_cast<std::uint64_t>(rounded) << kMantissaBits));
}

/// base^exponent for base >= 1 and exponent > 0, to a few units of 1e-16 times 1 + log2 of the result; below 2^1000.
inline double power(double base, double exponent) { return exp2_of(exponent * log2_of(base)); }

}  // namespace asperity
