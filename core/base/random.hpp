#pragma once
#include <cstdint>
#include <string_view>

namespace asperity {

/// A named stream of pseudo-random numbers: xoshiro256** (Blackman & Vigna 2021) seeded by splitmix64 from the run's
/// master seed and the stream's name. Distributions are our own, because the standard library's are not portable: the
/// same seed gives the same numbers with every compiler.
class RandomStream {
 public:
  RandomStream(std::uint64_t master_seed, std::string_view name);
  std::uint64_t next();
  double uniform();                         ///< In [0, 1), 53 bits.
  double uniform(double low, double high);  ///< In [low, high).
  double normal();                          ///< Mean 0, standard deviation 1 (Marsaglia's polar method).
  std::uint64_t below(std::uint64_t n);     ///< In [0, n), unbiased; n > 0.

 private:
  std::uint64_t state_[4];
};

}  // namespace asperity
