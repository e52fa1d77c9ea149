#include "core/measurement/disc_gauge.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/models.hpp"
#include "tests/unit/measurement/small_specimen.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

/// A "disc" of 10 x 10 squares of 1 mm between platens.
System square_disc() {
  System system = test::make_system(testing::grid_mesh(10, 10, 1.0));
  system.platens.present = true;
  system.platens.y = {0.0, 10.0};
  system.platen_springs.other = {100.0, 0.0};
  return system;
}

DiscGauge gauge_of(const System& system) { return make_disc_gauge(system.contacts, system.particles, 10.0); }

}  // namespace

TEST_CASE("the centre's stress is the mean of what lies within a tenth of the diameter") {
  System system = square_disc();
  const DiscGauge gauge = gauge_of(system);
  CHECK(gauge.centre.size() == 8);  // the four squares around the centre; the corners of the next lie farther
  Particles& p = system.particles;
  for (std::size_t i = 0; i < p.node_count(); ++i) {
    const Vec2 x = p.reference(i);
    p.position[i] = {1.0001 * x.x, 0.9997 * x.y};
  }
  const auto expected = triangle_stress(p, static_cast<std::size_t>(gauge.centre[0]));
  const DiscReading uniform = read_disc_gauge(gauge, system);
  CHECK(expected[1] < 0.0);
  CHECK(uniform.centre_tension_mpa == Approx(expected[0]).epsilon(1e-9));
  CHECK(uniform.centre_compression_mpa == Approx(-expected[1]).epsilon(1e-9));
  for (int node : p.triangles[0]) p.position[static_cast<std::size_t>(node)] += {0.1, 0.2};  // far from the centre
  CHECK(read_disc_gauge(gauge, system).centre_tension_mpa == uniform.centre_tension_mpa);
}

TEST_CASE("the contact is as wide as the rim that the platens press, the mean of both") {
  System system = square_disc();
  const DiscGauge gauge = gauge_of(system);
  CHECK(read_disc_gauge(gauge, system).contact_half_angle_deg == 0.0);
  // Two edges of the bottom sink in: two millimetres of a diameter of ten at one platen of two.
  Particles& p = system.particles;
  for (int triangle : {8, 10}) {
    for (int node : p.triangles[static_cast<std::size_t>(triangle)])
      p.position[static_cast<std::size_t>(node)].y -= 0.01;
  }
  CHECK(read_disc_gauge(gauge, system).contact_half_angle_deg == Approx(0.5 * 0.2 * 180 / M_PI));
}

TEST_CASE("a disc too coarse for its centre has no stress there, and a specimen that is none no reading") {
  System system = square_disc();
  DiscGauge gauge = gauge_of(system);
  gauge.centre.clear();
  CHECK(std::isnan(read_disc_gauge(gauge, system).centre_tension_mpa));
  CHECK(read_disc_gauge({}, system).centre_tension_mpa == 0.0);
}
