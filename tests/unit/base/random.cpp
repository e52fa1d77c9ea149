#include "core/base/random.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

using namespace asperity;

// Golden numbers: splitmix64, FNV-1a and xoshiro256** written a second time, in Python's integers.
TEST_CASE("streams give the same numbers for ever") {
  RandomStream mesh(1, "mesh");
  CHECK(mesh.next() == 0x57f1f35245f4dc64u);
  CHECK(mesh.next() == 0x200cb9825a26e0e3u);
  CHECK(mesh.next() == 0x12a87d6ebb584c1bu);
  CHECK(mesh.next() == 0x70c582e494616d7du);
  CHECK(RandomStream(2, "mesh").next() == 0xfd7cf842f341a7c2u);
  CHECK(RandomStream(1, "grains").next() == 0xf9466e5acc497e55u);
}

TEST_CASE("uniform numbers are the upper 53 bits") {
  RandomStream mesh(1, "mesh");
  CHECK(mesh.uniform() == 0.3435356212484807);
  CHECK(mesh.uniform(10, 12) == 10 + 2 * 0.12519416267800976);
}

namespace {

struct Moments {
  double mean = 0, variance = 0, skewness = 0, kurtosis = 0;
};

Moments moments_of(const std::vector<double>& values) {
  const double n = static_cast<double>(values.size());
  Moments m;
  for (const double v : values) m.mean += v / n;
  for (const double v : values) {
    const double d = v - m.mean;
    m.variance += d * d / n, m.skewness += d * d * d / n, m.kurtosis += d * d * d * d / n;
  }
  m.skewness /= std::pow(m.variance, 1.5), m.kurtosis /= m.variance * m.variance;
  return m;
}

constexpr std::size_t kDraws = 200000;
const double kRoot = std::sqrt(static_cast<double>(kDraws));

template <class Draw>
Moments moments(const Draw& draw) {
  std::vector<double> values(kDraws);
  for (double& value : values) value = draw();
  return moments_of(values);
}

}  // namespace

// Tolerances: four standard errors of each moment for 200,000 independent draws.
TEST_CASE("uniform numbers have the moments of a uniform distribution") {
  RandomStream stream(7, "moments");
  const Moments m = moments([&] { return stream.uniform(); });
  CHECK(m.mean == Approx(0.5).margin(4 * std::sqrt(1.0 / 12) / kRoot));
  CHECK(m.variance == Approx(1.0 / 12).margin(4 * std::sqrt(1.0 / 180) / kRoot));
}

TEST_CASE("normal numbers have the moments of a normal distribution") {
  RandomStream stream(7, "moments");
  const Moments m = moments([&] { return stream.normal(); });
  CHECK(m.mean == Approx(0).margin(4 / kRoot));
  CHECK(m.variance == Approx(1).margin(4 * std::sqrt(2.0) / kRoot));
  CHECK(m.skewness == Approx(0).margin(4 * std::sqrt(6.0) / kRoot));
  CHECK(m.kurtosis == Approx(3).margin(4 * std::sqrt(24.0) / kRoot));
}

TEST_CASE("below(n) stays below n and is even over its values") {
  RandomStream stream(7, "below");
  std::array<int, 6> counts{};
  for (std::size_t i = 0; i < kDraws; ++i) ++counts.at(stream.below(6));
  const double expected = kDraws / 6.0;
  double chi_square = 0;
  for (const int count : counts) chi_square += (count - expected) * (count - expected) / expected;
  CHECK(chi_square < 20.5);  // 99.9 % quantile for five degrees of freedom.
  CHECK(stream.below(1) == 0);
}

TEST_CASE("streams of different names or seeds are not correlated") {
  RandomStream a(1, "mesh");
  RandomStream b(1, "grains");
  RandomStream c(2, "mesh");
  double ab = 0;
  double ac = 0;
  for (std::size_t i = 0; i < kDraws; ++i) {
    const double x = a.uniform() - 0.5;
    ab += x * (b.uniform() - 0.5);
    ac += x * (c.uniform() - 0.5);
  }
  // A sum of independent products has standard deviation sqrt(n) / 12.
  CHECK(std::abs(ab) < 4 * kRoot / 12);
  CHECK(std::abs(ac) < 4 * kRoot / 12);
}
