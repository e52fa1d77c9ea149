#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/sliders.hpp"

using namespace asperity;

/// Eqs. (C55), (C56) on a block drawn over a surface.
namespace {

const ParallelLoops kLoops;
constexpr double kMu = 0.5;

struct Slider {
  System system;
  test::Drive drive;
  double normal_force;  ///< N per mm
};

/// A block of five irregular edges on a held surface of few long ones, pressed down by its weight.
Slider slider(double pressure, const FrictionWear& wear) {
  test::BodyMaterial material;
  material.surface.tan_phi = kMu;
  material.surface.wear = wear;
  const std::vector<double> widths = test::irregular_lengths(5, 1.7, 2);
  double length = 0;
  for (double w : widths) length += w;
  test::Bodies bodies;
  test::add_strip(bodies, {-10.0, -2.0}, test::irregular_lengths(20, 2.0, 1), 1, 2.0);
  test::add_strip(bodies, {0.0, -pressure / material.surface.k_n}, widths, 2, 3.4);
  Slider block{test::make_bodies(bodies, material, 0.5), {}, pressure * length};
  test::hold(block.system, 0);
  block.system.body_acceleration = {0.0, -block.normal_force / test::motion_of(block.system, 1).mass};
  block.system.local_damping = 0.4;
  block.drive = test::drive_above(block.system, 1, 3.0);
  return block;
}

/// Draws it along; the mean friction over the normal force in the last tenth of the way.
double slide(Slider& block, double way) {
  constexpr double kSpeed = 3000.0, kRamp = 1e-3;  // mm/s, s
  double x = 0.0, sum = 0.0;
  int count = 0;
  while (x < way) {
    const double v = kSpeed * std::min(1.0, block.system.time / kRamp);
    test::advance_driven(block.system, block.drive, v, kLoops);
    x += v * block.system.time_step;
    if (x < 0.9 * way) continue;
    sum += test::force_on(block.system, 0).x / block.normal_force;
    ++count;
  }
  return sum / count;
}

/// Wear of one of the block's lower edges, which slide all the way, and its length; mm.
struct WornEdge {
  double wear, length;
};

std::vector<WornEdge> base_edges(const System& system) {
  std::vector<WornEdge> edges;
  for (const ContactMember& m : system.general.members) {
    if (system.particles.grain[m.triangle] != 1) continue;
    for (int k = 0; k < 3; ++k) {
      const auto& nodes = system.particles.triangles[m.triangle];
      const Vec2 a = system.particles.reference(nodes[k]), b = system.particles.reference(nodes[(k + 1) % 3]);
      if (a.y < 0.1 && b.y < 0.1) edges.push_back({system.general.wear[3 * m.triangle + k], norm(b - a)});
    }
  }
  return edges;
}

}  // namespace

TEST_CASE("a sliding base wears by the way it slides, and its friction falls to the exponential's value") {
  const double way = 4.0;
  Slider block = slider(2.0, {0.6, 2.0, 0.0});
  const double friction = slide(block, way);
  const double expected = kMu * (0.6 + 0.4 * std::exp(-0.95 * way / 2.0));  // in the middle of the last tenth
  const std::vector<WornEdge> edges = base_edges(block.system);
  REQUIRE(edges.size() == 5);
  WARN("friction " << friction << " where the exponential has " << expected << "; wear of the base "
                   << edges.front().wear << " to " << edges.back().wear << " mm after " << way << " mm");
  for (const WornEdge& e : edges) CHECK(e.wear == Approx(way).epsilon(0.01));  // less the elastic way
  CHECK(friction == Approx(expected).epsilon(0.02));
}

TEST_CASE("under a reference stress wear goes with the normal stress") {
  std::array<double, 2> mean{};
  for (const int i : {0, 1}) {
    Slider block = slider(i == 0 ? 1.0 : 2.0, {0.8, 1.0, 4.0});
    slide(block, 2.0);
    double length = 0.0;
    for (const WornEdge& e : base_edges(block.system)) {
      mean[i] += e.wear * e.length;
      length += e.length;
    }
    mean[i] /= length;
  }
  WARN("mean wear after 2 mm, reference 4 MPa: " << mean[0] << " mm at 1 MPa, " << mean[1] << " mm at 2 MPa");
  CHECK(mean[0] == Approx(2.0 * 1.0 / 4.0).epsilon(0.05));  // friction tips the block a little; springs' elastic way
  CHECK(mean[1] / mean[0] == Approx(2.0).epsilon(0.05));
}

TEST_CASE("a residual share of 1 is the surface that does not wear, bit for bit") {
  Slider worn = slider(2.0, {1.0, 0.1, 0.0}), plain = slider(2.0, {});
  slide(worn, 0.5);
  slide(plain, 0.5);
  CHECK(worn.system.general.wear.empty());
  for (std::size_t i = 0; i < plain.system.particles.node_count(); ++i) {
    REQUIRE(worn.system.particles.position[i].x == plain.system.particles.position[i].x);
    REQUIRE(worn.system.particles.position[i].y == plain.system.particles.position[i].y);
  }
}
