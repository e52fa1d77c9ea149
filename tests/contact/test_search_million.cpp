#include <catch2/catch.hpp>

#include "tests/support/scattered.hpp"

using namespace asperity;

TEST_CASE("A search among a million exposed triangles costs at most 1.5 times as much a triangle as among 64k") {
  const double small = test::search_seconds_per_triangle(1 << 16), large = test::search_seconds_per_triangle(1 << 20);
  CAPTURE(small, large);
  CHECK(large < 1.5 * small);
  WARN("search: " << 1e9 * small << " ns a triangle at 64k, " << 1e9 * large << " at 1M, ratio " << large / small);
}
