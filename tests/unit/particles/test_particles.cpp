#include <catch2/catch.hpp>

#include "tests/support/models.hpp"

using namespace asperity;

TEST_CASE("plane constants are those of the textbook") {
  const ElasticConstants stress = elastic_constants(1000.0, 0.25, PlaneCondition::stress);
  CHECK(stress.c11 == Approx(1000.0 / (1.0 - 0.0625)));
  CHECK(stress.c12 == Approx(0.25 * stress.c11));
  CHECK(stress.shear == Approx(400.0));
  CHECK(stress.out_of_plane == 0.0);
  const ElasticConstants strain = elastic_constants(1000.0, 0.25, PlaneCondition::strain);
  CHECK(strain.c11 == Approx(1200.0));  // E (1 - nu) / ((1 + nu) (1 - 2 nu))
  CHECK(strain.c12 == Approx(400.0));
  CHECK(strain.out_of_plane == 0.25);
}

TEST_CASE("a third of each triangle's mass sits on each corner, and grains share nodes") {
  const Mesh mesh = test::grid_mesh({3, 2});
  const RunConfig config = test::plaster();
  const Particles apart = make_particles(mesh, config.particles, PlaneCondition::stress);
  const Particles joined = make_particles(test::continuum(mesh), config.particles, PlaneCondition::stress);
  CHECK(apart.node_count() == 3 * mesh.triangles.size());
  CHECK(joined.node_count() == mesh.vertices.size());
  for (const Particles* p : {&apart, &joined}) {
    double mass = 0.0;
    for (double m : p->mass) mass += m;
    CHECK(mass == Approx(1200e-12 * 6.0 * 4.0));  // 1200 kg/m3 in tonne/mm3, 3 x 2 cells of 2 x 2 mm
  }
}

TEST_CASE("Cauchy stress turns with the particle") {
  const Mesh mesh = test::grid_mesh({1, 1});
  Particles p = make_particles(mesh, test::plaster().particles, PlaneCondition::stress);
  for (Vec2& x : p.position) x.x *= 1.001;
  const auto before = triangle_stress(p, 0);
  for (Vec2& x : p.position) x = test::turned(x, 1.5707963267948966);
  const auto after = triangle_stress(p, 0);
  CHECK(after[1] == Approx(before[0]));
  CHECK(after[0] == Approx(before[1]));
  CHECK(after[3] == Approx(-before[3]).margin(1e-12));
}
