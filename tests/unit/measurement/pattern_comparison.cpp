#include "core/measurement/pattern_comparison.hpp"

#include <catch2/catch.hpp>
#include <numeric>

#include "tests/support/synthetic_frame.hpp"
#include "tests/unit/measurement/patterns.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

/// One straight crack of `length` mm at an angle from the loading axis.
CrackPattern line_at(double angle_deg, double length = 10.0) {
  const double angle = angle_deg * std::numbers::pi / 180.0;
  return straight({0, 0}, length * Vec2{std::sin(angle), std::cos(angle)}, 1, BreakMode::tension);
}

Frame shifted(Frame frame, Vec2 by) {
  for (Vec2& p : frame.position) p += by;
  return frame;
}

}  // namespace

TEST_CASE("Orientation shares put length where it points, and sum to one") {
  const OrientationShares shares = orientation_shares(line_at(15, 3) + line_at(-85, 1) + line_at(95, 4));
  CHECK(shares[10] == Approx(3.0 / 8));
  CHECK(shares[0] == Approx(5.0 / 8));  // 95 degrees is -85
  CHECK(std::accumulate(shares.begin(), shares.end(), 0.0) == Approx(1.0));
  CHECK(std::isnan(orientation_shares({})[3]));
}

TEST_CASE("The distance of orientations is the angle turned, the short way round, whichever end comes first") {
  CHECK(orientation_distance_deg(line_at(10), line_at(40)) == Approx(30));
  CHECK(orientation_distance_deg(line_at(80), line_at(-80)) == Approx(20));
  CHECK(orientation_distance_deg(line_at(0), line_at(180)) == Approx(0).margin(1e-9));
  CHECK(orientation_distance_deg(line_at(-45), line_at(45)) == Approx(90));
  CHECK(std::isnan(orientation_distance_deg({}, line_at(0))));
}

TEST_CASE(
    "The distance of orientations weighs by length, is symmetric, and does not depend on where the circle is cut") {
  const CrackPattern half_turned = line_at(0, 5) + line_at(60, 5);
  CHECK(orientation_distance_deg(line_at(0), half_turned) == Approx(30));
  const CrackPattern a = scattered(40, 50, 100, 2, 1), b = scattered(60, 50, 100, 3, 2);
  const double distance = orientation_distance_deg(a, b);
  CHECK(distance > 0.5);
  CHECK(distance < 45);
  CHECK(orientation_distance_deg(b, a) == Approx(distance));
  const auto turned = [](CrackPattern pattern, double by_deg) {
    const double c = std::cos(by_deg * std::numbers::pi / 180), s = std::sin(by_deg * std::numbers::pi / 180);
    for (CrackLine& crack : pattern)
      for (Vec2& end : crack.end) end = {c * end.x - s * end.y, s * end.x + c * end.y};
    return pattern;
  };
  for (const double by : {37.0, 90.0, 141.0})
    CHECK(orientation_distance_deg(turned(a, by), turned(b, by)) == Approx(distance));
}

TEST_CASE("A mesh is the same however it moves, and another one is not") {
  const Frame disc = test::synthetic_disc();
  Frame moved = disc;
  for (std::size_t i = 0; i < moved.position.size(); ++i) {
    moved.position[i] += Vec2{0.3, -0.2};
    moved.displacement[i] += Vec2{0.3, -0.2};
  }
  CHECK(same_mesh(disc, moved));
  CHECK_FALSE(same_mesh(disc, shifted(disc, {0.01, 0})));
  CHECK_FALSE(same_mesh(disc, test::synthetic_rectangle()));
}

TEST_CASE("Damage overlaps wholly with itself, by half with twice itself, not at all elsewhere") {
  const Frame disc = test::synthetic_disc();
  Frame half = disc, left = disc, right = disc;
  for (std::size_t i = 0; i < disc.triangles.size(); ++i) {
    half.damage[i] *= 0.5;
    const bool on_left = test::centre_of(disc, i).x < 0;
    (on_left ? right : left).damage[i] = 0;
  }
  CHECK(damage_overlap_on_mesh(disc, disc) == Approx(1));
  CHECK(damage_overlap_on_mesh(disc, half) == Approx(0.5));
  CHECK(damage_overlap_on_mesh(left, right) == 0);
  CHECK(damage_overlap_on_grid(disc, disc, 4) == Approx(1));
  CHECK(damage_overlap_on_grid(half, disc, 4) == Approx(0.5));
  CHECK(damage_overlap_on_grid(left, right, 4) < 0.1);  // cells that both halves have a part of
  Frame sound = disc;
  std::fill(sound.damage.begin(), sound.damage.end(), 0.0);
  CHECK(std::isnan(damage_overlap_on_mesh(sound, sound)));
}

TEST_CASE("On a grid a pattern shifted within its cells is nearly the same, and one shifted away is not") {
  const Frame disc = test::synthetic_disc();
  CHECK(damage_overlap_on_grid(disc, shifted(disc, {0.3, 0}), 4) > 0.85);
  CHECK(damage_overlap_on_grid(disc, shifted(disc, {15, 0}), 4) < 0.35);
}

TEST_CASE("The mean edge is that of the lattice") {
  CHECK(mean_edge_mm(test::synthetic_disc()) == Approx(test::kEdgeMm));
}
