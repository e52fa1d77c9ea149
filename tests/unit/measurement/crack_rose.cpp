#include "core/measurement/crack_rose.hpp"

#include <catch2/catch.hpp>

using namespace asperity;

TEST_CASE("A rose of known directions") {
  const std::vector<double> orientation{0.0, 9.99, 10.0, 45.0, 90.0, 179.0, 180.0};
  const std::vector<double> length{1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0};
  const std::vector<double> rose = rose_lengths(orientation, length, 18);
  REQUIRE(rose.size() == 18);
  CHECK(rose[0] == 67.0);  // 0, 9.99 and 180, which is 0
  CHECK(rose[1] == 4.0);
  CHECK(rose[4] == 8.0);
  CHECK(rose[9] == 16.0);
  CHECK(rose[17] == 32.0);
  double sum = 0.0;
  for (const double l : rose) sum += l;
  CHECK(sum == 127.0);
}
