#include <catch2/catch.hpp>
#include <map>
#include <numbers>

#include "core/geometry/grains.hpp"
#include "tests/unit/geometry/mesh_checks.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

ParticleConfig grains_of(double grain_mm, double edge_mm, std::uint64_t seed) {
  ParticleConfig p = particles(ParticleKind::voronoi, edge_mm, seed);
  p.grain_size_mm = grain_mm;
  return p;
}

/// Grain pieces that hang together by shared edges; as many as grains if every grain is connected.
int connected_pieces(const Mesh& mesh) {
  std::vector<int> root(mesh.triangles.size());
  for (std::size_t t = 0; t < root.size(); ++t) root[t] = static_cast<int>(t);
  const auto find = [&](int t) {
    while (root[t] != t) t = root[t] = root[root[t]];
    return t;
  };
  int pieces = static_cast<int>(root.size());
  for (const MeshEdge& e : mesh_edges(mesh)) {
    if (e.right < 0 || mesh.grain[e.left] != mesh.grain[e.right]) continue;
    const int a = find(e.left), b = find(e.right);
    if (a == b) continue;
    root[a] = b;
    --pieces;
  }
  return pieces;
}

void check_grains(const Mesh& mesh, double angle_min_deg) {
  const MeshQuality q = measure_quality(mesh);
  CHECK(q.angle_min_deg >= angle_min_deg);
  CHECK(all_counter_clockwise(mesh));
  CHECK(euler_characteristic(mesh) == 1);
  CHECK(connected_pieces(mesh) == q.grains);
  std::map<int, int> triangles;
  for (int grain : mesh.grain) ++triangles[grain];
  CHECK(static_cast<int>(triangles.size()) == q.grains);
  for (const auto& [grain, count] : triangles) CHECK(count >= 2);
}

}  // namespace

TEST_CASE("grains of the default size over ten seeds") {
  for (const ExperimentConfig& experiment : {rectangle_experiment(), disc_experiment()})
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const Mesh mesh = make_mesh(experiment, grains_of(4.0, 2.0, seed));
      INFO("seed " << seed);
      check_grains(mesh, 10.0);
      const MeshQuality q = measure_quality(mesh);
      // Grains of the mean diameter's area; collapsing borders may lose one or two.
      CHECK(q.outline_area_mm2 / q.grains == Approx(std::numbers::pi * 4.0).epsilon(0.01));
      CHECK(q.edge_mean_mm == Approx(2.0).epsilon(0.06));
      CHECK(q.edge_min_mm >= 0.8 * (1.0 - 1e-12));  // Collapsed below 0.4 edges.
    }
}

TEST_CASE("coarse and fine grains") {
  check_grains(make_mesh(disc_experiment(), grains_of(10.0, 2.0, 1)), 10.0);
  check_grains(make_mesh(disc_experiment(), grains_of(2.0, 2.0, 1)), 10.0);
  check_grains(make_mesh(disc_experiment(), grains_of(6.0, 1.0, 1)), 10.0);
}

TEST_CASE("the outline is followed by grains too") {
  const Mesh rectangle = make_mesh(rectangle_experiment(), grains_of(4.0, 2.0, 2));
  CHECK(outline_length(rectangle, Boundary::bottom) == Approx(54.0).epsilon(1e-13));
  CHECK(outline_length(rectangle, Boundary::right) == Approx(130.0).epsilon(1e-13));
  CHECK(measure_quality(rectangle).area_mm2 == Approx(7020.0).epsilon(1e-12));
  const Mesh disc = make_mesh(disc_experiment(), grains_of(4.0, 2.0, 2));
  for (const MeshEdge& e : mesh_edges(disc))
    if (e.right < 0) CHECK(norm(disc.vertices[e.a] - Vec2{0, 27}) == Approx(27.0).epsilon(1e-14));
  CHECK(measure_quality(disc).area_error < 0.0012);
}

TEST_CASE("Lloyd's steps even the grains out") {
  const auto roughness = [](int steps) {
    const Outline outline = outline_of(Rectangle{54.0, 130.0});
    RandomStream random(3, "test");
    const std::vector<Vec2> centres = grain_centres(outline, 4.0, steps, random);
    double sum = 0.0;
    for (const Vec2& p : centres) {
      double nearest = 1e9;
      for (const Vec2& q : centres)
        if (!(p == q)) nearest = std::min(nearest, norm(p - q));
      sum += nearest;
    }
    return 4.0 - sum / static_cast<double>(centres.size());
  };
  CHECK(roughness(4) < roughness(1));
  CHECK(roughness(1) < roughness(0));
}

TEST_CASE("two centres in a square have one straight border between them") {
  const Outline square = outline_of(Rectangle{2.0, 2.0});
  const GrainBorders borders = grain_borders(square, {{-0.5, 1.0}, {0.5, 1.0}}, 5.0, 0.1);
  REQUIRE(borders.inner.size() == 1);
  CHECK(borders.loop.size() == 6);
  for (int c : borders.inner[0]) CHECK(borders.corners[c].at.x == Approx(0.0).margin(1e-15));
}
