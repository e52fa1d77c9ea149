#include <catch2/catch.hpp>
#include <cmath>

#include "tests/unit/geometry/mesh_checks.hpp"

using namespace asperity;
using namespace asperity::test;

TEST_CASE("the unit square's quality is what one computes by hand") {
  Mesh square = unit_square();
  square.outline_area_mm2 = 1.25;
  const MeshQuality q = measure_quality(square);
  CHECK(q.triangles == 2);
  CHECK(q.vertices == 4);
  CHECK(q.grains == 2);
  CHECK(q.edges == 5);
  CHECK(q.outline_edges == 4);
  const double diagonal = std::sqrt(2.0), mean = (4.0 + diagonal) / 5.0;
  CHECK(q.edge_mean_mm == Approx(mean));
  CHECK(q.edge_deviation_mm == Approx(std::sqrt((4.0 + 2.0) / 5.0 - mean * mean)));
  CHECK(q.edge_min_mm == Approx(1.0));
  CHECK(q.edge_max_mm == Approx(diagonal));
  CHECK(q.angle_min_deg == Approx(45.0));
  CHECK(q.angle_max_deg == Approx(90.0));
  CHECK(q.area_mm2 == Approx(1.0));
  CHECK(q.area_error == Approx(0.2));
}

TEST_CASE("a hexagonal crystal has bond order one and six edges at every inner vertex") {
  Mesh crystal;
  crystal.vertices = {{0, 0}};
  for (int k = 0; k < 6; ++k) {
    const double angle = 0.3 + k * std::acos(0.5);
    crystal.vertices.push_back({std::cos(angle), std::sin(angle)});
    crystal.triangles.push_back({0, k + 1, (k + 1) % 6 + 1});
    crystal.grain.push_back(k);
  }
  const MeshQuality q = measure_quality(crystal);
  CHECK(q.bond_order == Approx(1.0));
  CHECK(q.sixfold_fraction == 1.0);
  CHECK(q.edge_deviation_mm == Approx(0.0).margin(1e-12));
  CHECK(q.angle_min_deg == Approx(60.0));
  CHECK(q.area_error == 0.0);
}

TEST_CASE("an empty mesh has an empty quality") { CHECK(measure_quality(Mesh{}).triangles == 0); }
