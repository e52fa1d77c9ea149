#include "core/base/parallel.hpp"

#include <oneapi/tbb/global_control.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <vector>

using namespace asperity;

namespace {

/// Terms of very different size, so that any other order of summation rounds differently.
double term(std::size_t i) { return std::sin(static_cast<double>(i)) * std::pow(10.0, static_cast<double>(i % 17)); }

/// TBB grants no more threads than cores unless told so: without this, four threads would be one on a small machine.
const oneapi::tbb::global_control kFourThreads(oneapi::tbb::global_control::max_allowed_parallelism, 4);

double sum_of_terms(std::size_t n, int threads) {
  const ParallelLoops loops(threads);
  return loops.sum_blocks<double>(n, [](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) sum += term(i);
    return sum;
  });
}

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

}  // namespace

TEST_CASE("sums are bitwise the same for any number of threads") {
  const std::size_t n = GENERATE(0u, 1u, 1023u, 1024u, 1025u, 100000u);
  const double one = sum_of_terms(n, 1);
  CHECK(same_bits(one, sum_of_terms(n, 2)));
  CHECK(same_bits(one, sum_of_terms(n, 4)));
}

TEST_CASE("the test's terms do feel the order of summation") {
  double straight = 0;
  for (std::size_t i = 0; i < 100000; ++i) straight += term(i);
  CHECK_FALSE(same_bits(straight, sum_of_terms(100000, 1)));
}

TEST_CASE("blocks cover every index once") {
  const int threads = GENERATE(1, 3);
  std::vector<int> visits(5000, 0);
  ParallelLoops(threads).for_blocks(visits.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) ++visits[i];
  });
  CHECK(visits == std::vector<int>(5000, 1));
}

TEST_CASE("an exception in a block reaches the caller") {
  const int threads = GENERATE(1, 2);
  const auto fail = [](std::size_t, std::size_t) { throw std::runtime_error("guard"); };
  CHECK_THROWS_WITH(ParallelLoops(threads).for_blocks(5000, fail), "guard");
}
