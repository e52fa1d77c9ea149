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

TEST_CASE("a triangle yields at its largest difference of principal stresses, and gives the work that took") {
  const Mesh mesh = test::grid_mesh({1, 1});
  Particles p = make_particles(mesh, test::plaster().particles, PlaneCondition::strain);
  set_yield_stress(p, 2.0);
  const double g = p.elastic.shear;
  const auto sheared = [&](double strain) {  // pure shear e12, no rotation
    for (std::size_t i = 0; i < p.node_count(); ++i) {
      const Vec2 at = p.reference(i);
      p.position[i] = {at.x + strain * at.y, at.y + strain * at.x};
    }
    return update_triangle(p, 0);
  };
  CHECK(sheared(0.4 / g).t12 == Approx(0.8));  // elastic below Y / 2 = 1 MPa
  CHECK(plastic_work(p, 0) == 0.0);
  const BiotState beyond = sheared(1.5 / g);
  CHECK(beyond.t12 == Approx(1.0));
  CHECK(p.plastic(0).shear == Approx(1.0 / g));  // of 1.5 / G, 0.5 / G stays elastic
  CHECK(p.plastic(0).difference == Approx(0.0).margin(1e-15));
  CHECK(plastic_work(p, 0) == Approx(p.shape(0).area * 2.0 * 1.0 * (1.0 / g)));  // 2 t12 d(e12)
  const BiotState unloaded = sheared(1.0 / g);  // elastic unloading to zero stress at the plastic strain
  CHECK(unloaded.t12 == Approx(0.0).margin(1e-9));
  CHECK(triangle_energy(p, 0) == Approx(0.0).margin(1e-12));
  CHECK(p.plastic(0).shear == Approx(1.0 / g));
}

TEST_CASE("pressure and stretching along an axis yield alike: the mean stress plays no part") {
  const Mesh mesh = test::grid_mesh({1, 1});
  Particles p = make_particles(mesh, test::plaster().particles, PlaneCondition::strain);
  set_yield_stress(p, 2.0);
  for (Vec2& x : p.position) x = 0.9 * x;
  CHECK(update_triangle(p, 0).t11 == Approx(-0.1 * (p.elastic.c11 + p.elastic.c12)));
  CHECK(plastic_work(p, 0) == 0.0);
  for (Vec2& x : p.position) x.y *= 0.99;
  const BiotState s = update_triangle(p, 0);
  CHECK(s.t11 - s.t22 == Approx(2.0));
  CHECK(s.t11 + s.t22 == Approx(-(p.elastic.c11 + p.elastic.c12) * (0.1 + 1.0 - 0.891)));
}

TEST_CASE("triangles of the intact material do not yield") {
  const Mesh mesh = test::grid_mesh({1, 1});
  Particles p = make_particles(mesh, test::plaster().particles, PlaneCondition::strain);
  p.bulk = p.elastic;
  p.in_bulk = {1, 0};
  set_yield_stress(p, 1e-3);
  for (Vec2& x : p.position) x.y *= 0.99;
  update_triangle(p, 0);
  update_triangle(p, 1);
  CHECK(plastic_work(p, 0) == 0.0);
  CHECK(plastic_work(p, 1) > 0.0);
}
