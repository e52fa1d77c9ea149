#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/unit/base/power.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h:
#include <hwy/highway.h>

#include <vector>

#include "core/base/simd_power.inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace asperity::HWY_NAMESPACE {

/// power() in vector registers; the count is a multiple of eight.
void powers(const std::vector<double>& bases, double exponent, std::vector<double>& results) {
  const Doubles d;
  for (std::size_t i = 0; i < bases.size(); i += kLanes) {
    hn::StoreU(power(hn::LoadU(d, bases.data() + i), hn::Set(d, exponent)), d, results.data() + i);
  }
}

}  // namespace asperity::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "core/base/instruction_set.hpp"
#include "core/base/random.hpp"

namespace asperity {
HWY_EXPORT(powers);
}

using namespace asperity;

namespace {

/// Bases from 1 to 1e12, half of them within 1e-9 ... 1 above 1, where a contact's pressure is small.
std::vector<double> bases() {
  RandomStream random(5, "powers");
  std::vector<double> result{
      1.0, std::nextafter(1.0, 2.0), std::sqrt(2.0), std::nextafter(std::sqrt(2.0), 2.0), 2.0, 4.0, 1e12, 0x1p40};
  for (int i = 0; i < 40000; ++i) result.push_back(1.0 + std::pow(10.0, random.uniform(-9.0, i % 2 ? 0.0 : 12.0)));
  return result;
}

}  // namespace

TEST_CASE("the own power errs by less than 1e-14 for envelopes, and is exact where it is known") {
  double worst = 0.0, worst_scaled = 0.0;
  for (const double exponent : {0.4, 0.5, 0.6, 0.77, 0.999, 1.0, 2.5}) {
    for (const double base : bases()) {
      const long double exact = std::pow(static_cast<long double>(base), static_cast<long double>(exponent));
      const auto error = static_cast<double>(std::abs((power(base, exponent) - exact) / exact));
      if (exponent <= 1.0) worst = std::max(worst, error);
      worst_scaled = std::max(worst_scaled, error / (1.0 + exponent * std::log2(base)));
    }
  }
  WARN("own power: largest relative error " << worst << " for exponents up to 1; over 1 + log2(result) " << worst_scaled
                                            << " for all");
  CHECK(worst < 1e-14);
  CHECK(worst_scaled < 6e-16);  // the polynomials err by 2e-16 and 3e-16, their product is rounded
  CHECK(power(1.0, 0.6) == 1.0);
  CHECK(power(0x1p40, 0.5) == 0x1p20);
  CHECK(power(8.0, 1.0) == 8.0);
}

TEST_CASE("the own power has the same bits in vector registers, on every instruction set") {
  const std::vector<double> all = bases();
  REQUIRE(all.size() % 8 == 0);
  std::vector<double> one_by_one(all.size()), side_by_side(all.size());
  const std::vector<InstructionSet> sets = instruction_sets();
  for (const double exponent : {0.4, 0.6, 1.3}) {
    for (std::size_t i = 0; i < all.size(); ++i) one_by_one[i] = power(all[i], exponent);
    for (const InstructionSet& set : sets) {
      const ForcedInstructionSet forced(set);
      INFO(set.name);
      HWY_DYNAMIC_DISPATCH(powers)(all, exponent, side_by_side);
      CHECK(std::memcmp(one_by_one.data(), side_by_side.data(), all.size() * sizeof(double)) == 0);
    }
  }
  CHECK(sets.size() >= 2);
}
#endif
