#include "core/base/vec2.hpp"

#include <catch2/catch.hpp>

using namespace asperity;

TEST_CASE("vectors add, subtract and scale by component") {
  const Vec2 a{1, 2};
  const Vec2 b{3, -5};
  CHECK(a + b == Vec2{4, -3});
  CHECK(a - b == Vec2{-2, 7});
  CHECK(2 * b == Vec2{6, -10});
  Vec2 c = a;
  c += b;
  c -= a;
  CHECK(c == b);
}

TEST_CASE("dot, cross and norm by hand") {
  CHECK(dot({1, 2}, {3, -5}) == -7);
  CHECK(cross({1, 2}, {3, -5}) == -11);
  CHECK(cross({1, 0}, {0, 1}) == 1);
  CHECK(norm({3, -4}) == 5);
}
