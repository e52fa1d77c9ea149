#include "core/measurement/gauges.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/error.hpp"
#include "tests/unit/measurement/small_specimen.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

constexpr double kSide = 5.0;
// Readings are differences of means of some twenty displacements of order 1 mm, over some 30 mm.
constexpr double kRounding = 1e-15;

ExperimentConfig experiment() {
  ExperimentConfig e;
  e.type = ExperimentType::uniaxial;
  e.width_mm = 30;
  e.height_mm = 60;
  return e;
}

MeasurementConfig bands() {
  MeasurementConfig m;
  m.axial_gauge_mm = 30;
  m.lateral_gauge_mm = 20;
  return m;
}

/// A specimen of 30 x 60 mm with its gauges, and what they read after its points have moved.
struct Gauged {
  Particles particles = small_specimen(6, 12, kSide).particles;
  Gauges gauges = make_gauges(particles, experiment(), bands(), kSide);

  GaugeReading after(const auto& displacement) {
    for (std::size_t i = 0; i < particles.node_count(); ++i) {
      particles.position[i] = particles.reference(i) + displacement(particles.reference(i));
    }
    return read_gauges(gauges, particles);
  }
};

}  // namespace

TEST_CASE("gauges lie where the configuration says") {
  const Gauged g;
  for (int side = 0; side < 2; ++side) {
    const double sign = side == 0 ? -1 : 1;
    REQUIRE_FALSE(g.gauges.axial[side].empty());
    REQUIRE_FALSE(g.gauges.lateral[side].empty());
    for (int node : g.gauges.axial[side]) CHECK(std::abs(g.particles.reference(node).y - (30 + sign * 15)) <= kSide);
    for (int node : g.gauges.lateral[side]) {
      CHECK(g.particles.reference(node).x == sign * 15);
      CHECK(std::abs(g.particles.reference(node).y - 30) <= 10);
    }
  }
  CHECK(g.gauges.lateral_base_mm == 30);
}

TEST_CASE("a linear deformation is read as it is") {
  Gauged g;
  const GaugeReading r = g.after([](Vec2 x) { return Vec2{0.003 * x.x, -0.01 * x.y}; });
  CHECK(r.axial == Approx(0.01).margin(kRounding));
  CHECK(r.lateral == Approx(0.003).margin(kRounding));
}

TEST_CASE("the specimen's translation, and shear along the platens, are no strain of the gauges") {
  Gauged g;
  const GaugeReading moved = g.after([](Vec2) { return Vec2{0.5, -0.25}; });
  CHECK(moved.axial == Approx(0).margin(kRounding));
  CHECK(moved.lateral == Approx(0).margin(kRounding));
  const GaugeReading sheared = g.after([](Vec2 x) { return Vec2{0.01 * x.y, 0}; });
  CHECK(sheared.axial == Approx(0).margin(kRounding));
  CHECK(sheared.lateral == Approx(0).margin(kRounding));
}

TEST_CASE("what happens at the platens does not reach the gauges") {
  Gauged g;
  const GaugeReading r = g.after([](Vec2 x) { return x.y < 5 || x.y > 55 ? Vec2{0, 0.5} : Vec2{}; });
  CHECK(r.axial == 0);
  CHECK(r.lateral == 0);
}

TEST_CASE("an experiment without gauges reads zero") {
  const GaugeReading r = read_gauges(Gauges{}, small_specimen(1, 1).particles);
  CHECK(r.axial == 0);
  CHECK(r.lateral == 0);
}

TEST_CASE("a lateral gauge so short that no node lies in it is refused") {
  MeasurementConfig m = bands();
  m.lateral_gauge_mm = 1.0;
  ExperimentConfig e = experiment();
  e.height_mm = 65;  // mid-height lies between two rows of nodes
  const Particles particles = small_specimen(6, 13, kSide).particles;
  try {
    make_gauges(particles, e, m, kSide);
    FAIL("accepted");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::config);
    REQUIRE(error.faults().size() == 1);
    CHECK(error.faults()[0].where == "/measurement/lateral_gauge_mm");
  }
}
