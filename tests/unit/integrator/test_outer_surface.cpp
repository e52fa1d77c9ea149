#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "core/base/error.hpp"
#include "core/integrator/outer_surface.hpp"
#include "tests/support/models.hpp"

using namespace asperity;

namespace {

constexpr double kPressure = 3.7;    // MPa
constexpr double kRounding = 1e-12;  // relative; a hundred edges sum to some 1e-14
constexpr double kPi = 3.141592653589793;

using Polygon = std::vector<Vec2>;

/// Polygons, counter-clockwise; the edges of polygon i belong to triangle i.
struct Surface {
  std::vector<Vec2> position;
  std::vector<ExposedEdge> exposed;
  std::vector<std::uint8_t> carries;
};

Surface surface_of(const std::vector<Polygon>& polygons) {
  Surface s;
  for (const Polygon& polygon : polygons) {
    const int first = static_cast<int>(s.position.size()), count = static_cast<int>(polygon.size());
    for (int i = 0; i < count; ++i) {
      s.position.push_back(polygon[i]);
      s.exposed.push_back({{first + i, first + (i + 1) % count}, static_cast<int>(s.carries.size())});
    }
    s.carries.push_back(1);
  }
  return s;
}

using Shares = std::map<std::array<int, 2>, double>;

Shares shares(const Surface& s) {
  Shares by_nodes;
  for (const LoadedEdge& e : find_loaded_edges(s.position, s.exposed, s.carries)) by_nodes[e.nodes] = e.share;
  return by_nodes;
}

/// Forces on all edges that face left, on all that face right.
struct SideForces {
  Vec2 left, right;
};

SideForces side_forces(const Surface& s) {
  SideForces sum;
  for (const LoadedEdge& e : find_loaded_edges(s.position, s.exposed, s.carries)) {
    const Vec2 force = 2.0 * pressure_on_end(e, s.position, kPressure);
    (force.x > 0.0 ? sum.left : sum.right) += force;
  }
  return sum;
}

void check_side_forces(const Surface& s, double height) {
  const SideForces f = side_forces(s);
  CHECK(f.left.x == Approx(kPressure * height).epsilon(kRounding));
  CHECK(f.right.x == Approx(-kPressure * height).epsilon(kRounding));
}

Polygon star(RandomStream& random, Vec2 centre, int corners) {
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double radius = random.uniform(2.0, 10.0);
    polygon.push_back(centre + test::turned({radius, 0.0}, 2.0 * kPi * (i + random.uniform()) / corners));
  }
  return polygon;
}

std::vector<double> sorted_heights(const std::vector<Vec2>& position) {
  std::vector<double> heights;
  for (const Vec2 x : position) heights.push_back(x.y);
  std::sort(heights.begin(), heights.end());
  return heights;
}

/// Edge that a ray along +x (`side` 1) or -x (-1) at height y, from far away, meets first; -1: none.
int first_hit(const Surface& s, double y, double side) {
  int hit = -1;
  double nearest = 0.0;
  for (std::size_t i = 0; i < s.exposed.size(); ++i) {
    const Vec2 a = s.position[s.exposed[i].nodes[0]], b = s.position[s.exposed[i].nodes[1]];
    if ((a.y > y) == (b.y > y)) continue;
    const double depth = side * (a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
    if (hit < 0 || depth < nearest) nearest = depth, hit = static_cast<int>(i);
  }
  return hit;
}

/// The shares of polygons that do not cross, by rays: one from each side between any two heights of corners.
Shares shares_by_rays(const Surface& s) {
  Shares sum;
  const std::vector<double> y = sorted_heights(s.position);
  for (std::size_t i = 0; i + 1 < y.size(); ++i) {
    for (double side : {1.0, -1.0}) {
      const int hit = first_hit(s, 0.5 * (y[i] + y[i + 1]), side);
      if (hit < 0) continue;
      const auto& nodes = s.exposed[hit].nodes;
      sum[nodes] += (y[i + 1] - y[i]) / std::abs(s.position[nodes[1]].y - s.position[nodes[0]].y);
    }
  }
  return sum;
}

void check_equal(const Shares& a, const Shares& b) {
  REQUIRE(a.size() == b.size());
  for (const auto& [nodes, share] : a) {
    REQUIRE(b.contains(nodes));
    CHECK(share == Approx(b.at(nodes)).epsilon(kRounding));
  }
}

void shuffle(std::vector<ExposedEdge>& edges, RandomStream& random) {
  for (std::size_t i = edges.size(); i > 1; --i) std::swap(edges[i - 1], edges[random.below(i)]);
}

int node_of(const Particles& p, int triangle, int vertex) {
  const auto& nodes = p.triangles[triangle];
  return *std::find_if(nodes.begin(), nodes.end(), [&](int node) { return p.vertex[node] == vertex; });
}

/// The outline of a specimen whose ends stand on platens.
std::vector<ExposedEdge> outline(const Mesh& mesh, const Particles& p) {
  std::vector<ExposedEdge> edges;
  for (const MeshEdge& e : mesh_edges(mesh)) {
    if (e.boundary == Boundary::none) continue;
    const bool end = e.boundary == Boundary::bottom || e.boundary == Boundary::top;
    edges.push_back({{node_of(p, e.left, e.a), node_of(p, e.left, e.b)}, e.left, end});
  }
  return edges;
}

/// Breaks the contacts between neighbouring columns of a grid one cell high.
System columns_apart(int columns) {
  System system = test::make_system(test::grid_mesh({columns, 1}));
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const ContactEdge& e = system.contacts.edges[c];
    if (e.left_triangle() / 2 != e.right_triangle() / 2) system.contacts.broken_edge(c).break_time = 1.0;
  }
  return system;
}

std::vector<std::uint8_t> carrying(const System& system, const std::vector<std::uint8_t>& on_platen,
                                   const std::vector<std::array<int, 2>>& touching) {
  return carrying_triangles(system.contacts, system.particles, on_platen, touching);
}

using Flags = std::vector<std::uint8_t>;

}  // namespace

TEST_CASE("an intact rectangle bears the pressure on exactly its flanks, in their order") {
  const Mesh mesh = test::grid_mesh({3, 5});
  System system = test::make_system(mesh);
  const auto exposed = outline(mesh, system.particles);
  RandomStream random(5, "elastic separations");
  const bool deformed = GENERATE(false, true);
  if (deformed) {
    for (Vec2& x : system.particles.position) x += {random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05)};
  }
  const auto& x = system.particles.position;
  const Flags all(system.particles.triangle_count(), 1);
  const auto loaded = find_loaded_edges(
      closed_positions(x, joined_nodes(system.contacts, system.particles.node_count())), exposed, all);
  std::vector<std::array<int, 2>> flanks, found;
  for (const ExposedEdge& e : exposed) {
    if (!e.under_platen) flanks.push_back(e.nodes);
  }
  for (const LoadedEdge& e : loaded) {
    found.push_back(e.nodes);
    CHECK(e.share == 1.0);
    const Vec2 along = x[e.nodes[1]] - x[e.nodes[0]];
    const bool same_bits = pressure_on_end(e, x, kPressure) == (-0.5 * kPressure) * Vec2{along.y, -along.x};
    CHECK(same_bits);
  }
  CHECK(found == flanks);
  CHECK(found.size() == 10);
}

TEST_CASE("a spall that is held bears the pressure, and hands it to the face behind once it is loose") {
  Surface s = surface_of({{{0, 0}, {10, 0}, {10, 20}, {0, 20}, {0, 14}, {3, 10}, {0, 6}}, {{0, 14}, {0, 6}, {3, 10}}});
  const Shares held{{{1, 2}, 1.0}, {{3, 4}, 1.0}, {{6, 0}, 1.0}, {{7, 8}, 1.0}};
  CHECK(shares(s) == held);
  check_side_forces(s, 20.0);
  s.carries[1] = 0;
  const Shares loose{{{1, 2}, 1.0}, {{3, 4}, 1.0}, {{4, 5}, 1.0}, {{5, 6}, 1.0}, {{6, 0}, 1.0}};
  CHECK(shares(s) == loose);
  check_side_forces(s, 20.0);
  const Vec2 net = side_forces(s).left + side_forces(s).right;
  CHECK(std::abs(net.x) < kRounding * 20.0 * kPressure);
  CHECK(std::abs(net.y) < kRounding * 20.0 * kPressure);
}

TEST_CASE("a piece in front of half an edge leaves it half the pressure") {
  Surface s = surface_of({{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{-3, 5}, {-1, 5}, {-1, 20}, {-3, 20}}});
  const Shares expected{{{1, 2}, 1.0}, {{3, 0}, 0.5}, {{5, 6}, 2.0 / 3.0}, {{7, 4}, 1.0}};
  check_equal(shares(s), expected);
  check_side_forces(s, 20.0);
}

TEST_CASE("of a re-entrant notch only what is seen from the side is loaded") {
  const Surface s = surface_of({{{0, 0}, {10, 0}, {10, 20}, {0, 20}, {0, 12}, {4, 14}, {4, 6}, {0, 6}}});
  const Shares expected{{{1, 2}, 1.0}, {{3, 4}, 1.0}, {{5, 6}, 0.75}, {{7, 0}, 1.0}};
  CHECK(shares(s) == expected);
  check_side_forces(s, 20.0);
}

TEST_CASE("edges that cross are each loaded where they are the outer one") {
  const Surface s = surface_of({{{1, 0}, {9, 0}, {9, 10}, {0, 10}}, {{0, 0}, {9.5, 0}, {9.5, 10}, {1, 10}}});
  const Shares expected{{{3, 0}, 0.5}, {{5, 6}, 1.0}, {{7, 4}, 0.5}};
  check_equal(shares(s), expected);
}

TEST_CASE("an end under a platen takes no pressure, though it is tilted, and hides what is behind") {
  Surface s = surface_of({{{0, 0}, {10, 0}, {10, 20}, {0, 18}}, {{9.8, 18.5}, {9.9, 18.5}, {9.9, 19}, {9.8, 19}}});
  CHECK(shares(s).at({2, 3}) == 1.0);
  s.exposed[2].under_platen = true;
  const Shares expected{{{1, 2}, 1.0}, {{3, 0}, 1.0}};
  CHECK(shares(s) == expected);
}

TEST_CASE("a random star bears p times its height on each side, on the edges that rays meet") {
  RandomStream random(11, "stars");
  for (int i = 0; i < 50; ++i) {
    const Surface s = surface_of({star(random, {1.0, -2.0}, 5 + 7 * i)});
    const std::vector<double> y = sorted_heights(s.position);
    check_side_forces(s, y.back() - y.front());
    check_equal(shares(s), shares_by_rays(s));
  }
}

TEST_CASE("an edge of which nothing is hidden has share 1 to the last bit, whatever is behind it") {
  RandomStream random(13, "behind a wall");
  for (int i = 0; i < 50; ++i) {
    const Surface s = surface_of({star(random, {0, 0}, 30), {{-20, -10.3}, {-19, -10.3}, {-21, 11.7}}});
    CHECK(shares(s).at({32, 30}) == 1.0);
  }
}

TEST_CASE("the order of the edges does not matter, though pieces overlap") {
  RandomStream random(12, "overlapping stars");
  for (int i = 0; i < 20; ++i) {
    Surface s = surface_of({star(random, {0, 0}, 40), star(random, {5, 6}, 40), star(random, {-3, 4}, 40)});
    const std::vector<double> y = sorted_heights(s.position);
    check_side_forces(s, y.back() - y.front());
    const SideForces before = side_forces(s);
    shuffle(s.exposed, random);
    const SideForces after = side_forces(s);
    CHECK(norm(before.left - after.left) < kRounding * norm(before.left));
    CHECK(norm(before.right - after.right) < kRounding * norm(before.right));
  }
}

TEST_CASE("nothing exposed, nothing carried, nothing loaded") {
  CHECK(find_loaded_edges({}, {}, {}).empty());
  Surface s = surface_of({{{0, 0}, {1, 0}, {1, 1}}});
  s.carries = {0};
  CHECK(shares(s).empty());
}

TEST_CASE("fragments carry that stand on a platen or touch one that carries") {
  const System system = columns_apart(5);
  const Flags on_platen{1, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  CHECK(carrying(system, on_platen, {}) == Flags{1, 1, 0, 0, 0, 0, 0, 0, 0, 0});
  CHECK(carrying(system, on_platen, {{4, 3}, {1, 2}}) == Flags{1, 1, 1, 1, 1, 1, 0, 0, 0, 0});
  CHECK(carrying(system, on_platen, {{4, 3}, {1, 2}, {7, 8}}) == Flags{1, 1, 1, 1, 1, 1, 0, 0, 0, 0});
  CHECK(carrying(system, Flags(10, 0), {{4, 3}, {1, 2}}) == Flags(10, 0));
}

TEST_CASE("a grain carries as a whole, and so does an unbroken specimen") {
  const Flags on_platen{0, 0, 0, 1, 0, 0};
  CHECK(carrying(test::make_system(test::continuum(test::grid_mesh({3, 1}))), on_platen, {}) == Flags(6, 1));
  CHECK(carrying(test::make_system(test::grid_mesh({3, 1})), on_platen, {}) == Flags(6, 1));
}

TEST_CASE("nodes stay joined at a corner until its contacts are broken") {
  const System whole = test::make_system(test::grid_mesh({2, 1}));
  const System apart = columns_apart(2);
  const auto groups = [](const System& system) {
    const std::size_t nodes = system.particles.node_count();
    const std::vector<int> joined = joined_nodes(system.contacts, nodes);
    int count = 0;
    for (std::size_t i = 0; i < nodes; ++i) count += joined[i] == static_cast<int>(i);
    return count;
  };
  CHECK(groups(whole) == 6);
  CHECK(groups(apart) == 8);
  CHECK(closed_positions({{0, 1}, {2, 5}, {4, 3}}, {0, 1, 0}) == std::vector<Vec2>{{2, 2}, {2, 5}, {2, 2}});
}

TEST_CASE("a surface with a position that is no number is a numerical error") {
  Surface s = surface_of({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  CHECK(find_loaded_edges(s.position, s.exposed, s.carries).size() == 2);
  s.position[2].x = std::nan("");
  CHECK_THROWS_AS(find_loaded_edges(s.position, s.exposed, s.carries), Error);
}
