#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/geometry/box.hpp"
#include "tests/support/scattered.hpp"

using namespace asperity;

namespace {

using Pairs = std::vector<std::array<int, 2>>;

/// The pairs on the list, by triangle numbers as `name` gives them, sorted.
template <class Name>
Pairs listed(const GeneralContacts& general, const Name& name) {
  Pairs pairs;
  for (const MemberPair& pair : general.pairs) {
    const int a = name(general.members[pair.a].triangle), b = name(general.members[pair.b].triangle);
    pairs.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Pairs listed(const GeneralContacts& general) {
  return listed(general, [](int t) { return t; });
}

/// How far triangle b lies off the farthest-off edge of a, mm; edges run counter-clockwise.
double gap_below_edges(const std::array<Vec2, 3>& a, const std::array<Vec2, 3>& b) {
  double gap = -1e300;
  for (int k = 0; k < 3; ++k) {
    const Vec2 along = a[(k + 1) % 3] - a[k];
    const Vec2 out = (1.0 / norm(along)) * Vec2{along.y, -along.x};
    gap = std::max(gap, std::min({dot(out, b[0] - a[k]), dot(out, b[1] - a[k]), dot(out, b[2] - a[k])}));
  }
  return gap;
}

double box_gap(const std::array<Vec2, 3>& a, const std::array<Vec2, 3>& b) {
  const Box p = bounding_box(a), q = bounding_box(b);
  return std::max({p.low.x - q.high.x, q.low.x - p.high.x, p.low.y - q.high.y, q.low.y - p.high.y});
}

/// All pairs that no edge and no upright line keeps farther apart than `reach`.
Pairs brute_force(const Particles& p, double reach) {
  Pairs pairs;
  for (int a = 0; a < static_cast<int>(p.triangle_count()); ++a) {
    for (int b = a + 1; b < static_cast<int>(p.triangle_count()); ++b) {
      const auto x = p.corners(a), y = p.corners(b);
      if (box_gap(x, y) > reach || gap_below_edges(x, y) > reach || gap_below_edges(y, x) > reach) continue;
      pairs.push_back({a, b});
    }
  }
  return pairs;
}

}  // namespace

TEST_CASE("The search lists the pairs that brute force finds, whatever the numbering and the order of searches") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    test::BondedBodies model = test::scattered_triangles(400, seed);
    search_pairs(model.general, model.contacts, model.particles, ParallelLoops());
    const Pairs pairs = listed(model.general);
    CAPTURE(seed, pairs.size());
    CHECK(pairs.size() > 400);
    CHECK(pairs == brute_force(model.particles, model.general.skin));

    search_pairs(model.general, model.contacts, model.particles, ParallelLoops());
    CHECK(listed(model.general) == pairs);

    test::BondedBodies reversed = test::scattered_triangles(400, seed, true);
    search_pairs(reversed.general, reversed.contacts, reversed.particles, ParallelLoops());
    CHECK(listed(reversed.general, [](int t) { return 399 - t; }) == pairs);
  }
}

TEST_CASE("No pair that touches is missing from the list while nothing has moved farther than half the skin") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    test::BondedBodies model = test::scattered_triangles(300, seed);
    search_pairs(model.general, model.contacts, model.particles, ParallelLoops());
    const Pairs list = listed(model.general);
    const std::vector<Vec2> from = model.particles.position;
    RandomStream random(seed, "moves");
    int overlapping = 0;
    for (int trial = 0; trial < 5; ++trial) {
      for (std::size_t i = 0; i < from.size(); i += 3) {
        const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
        const Vec2 by = test::turned({0.4999 * model.general.skin, 0.0}, angle);
        for (int k = 0; k < 3; ++k) model.particles.position[i + k] = from[i + k] + by;
      }
      for (const auto& pair : brute_force(model.particles, 0.0)) {
        ++overlapping;
        CAPTURE(seed, trial, pair[0], pair[1]);
        REQUIRE(std::binary_search(list.begin(), list.end(), pair));
      }
    }
    CHECK(overlapping > 100);
  }
}

TEST_CASE("The time of a search goes with the number of triangles") {
  const double small = test::search_seconds_per_triangle(1 << 14), large = test::search_seconds_per_triangle(1 << 17);
  CAPTURE(small, large);
  // n log n alone gives 1.2; the rest of the margin is for caches and busy machines. Brute force would give 8.
  CHECK(large < 2.5 * small);
  WARN("search: " << 1e9 * small << " ns a triangle at 16k, " << 1e9 * large << " at 128k, ratio " << large / small);
}
