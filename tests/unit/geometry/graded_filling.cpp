#include "core/geometry/graded_filling.hpp"

#include <catch2/catch.hpp>

using namespace asperity;

namespace {

/// A line of points one edge apart along y = 0.
Grading grading_along(double length, double edge_mm, double coarse_edge_mm) {
  Grading grading{{}, edge_mm, coarse_edge_mm};
  const int pieces = static_cast<int>(length / edge_mm);
  for (int i = 0; i <= pieces; ++i) grading.fine.push_back({length * i / pieces, 0.0});
  return grading;
}

}  // namespace

TEST_CASE("edges grow with the distance from the fine line up to the coarse edge") {
  const Grading grading = grading_along(20.0, 0.5, 4.0);
  CHECK(grading.edge_at({3.0, 0.0}) == 0.5);
  CHECK(grading.edge_at({3.0, 5.0}) == Approx(2.0));
  CHECK(grading.edge_at({-4.0, -3.0}) == Approx(2.0));
  CHECK(grading.edge_at({3.0, 50.0}) == 4.0);
}

TEST_CASE("a graded part keeps its fine line and follows its border") {
  const Grading grading = grading_along(20.0, 0.5, 4.0);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    RandomStream random(seed, "test");
    const GradedFilling filling = fill_graded(grading, {{20.0, -15.0}, {0.0, -15.0}}, random);
    for (std::size_t i = 0; i < grading.fine.size(); ++i) CHECK(filling.set.points[i].at == grading.fine[i]);
    double area = 0.0, shortest = 1e9, longest = 0.0;
    for (const auto& [a, b, c] : filling.filled.mesh.triangles) {
      const Vec2 corner = filling.set.points[a].at;
      area += 0.5 * cross(filling.set.points[b].at - corner, filling.set.points[c].at - corner);
    }
    CHECK(area == Approx(300.0).epsilon(1e-12));
    for_each_edge(filling.filled.mesh, [&](int a, int b) {
      const double length = norm(filling.set.points[b].at - filling.set.points[a].at);
      shortest = std::min(shortest, length);
      longest = std::max(longest, length);
    });
    CHECK(shortest > 0.3);
    CHECK(longest < 6.0);
    CHECK(filling.filled.regularity.angle_min_deg > 25.0);
    // 410 equilateral triangles would have the edges of Eq. (G12).
    CHECK(filling.filled.mesh.triangles.size() > 250);
    CHECK(filling.filled.mesh.triangles.size() < 600);
  }
}
