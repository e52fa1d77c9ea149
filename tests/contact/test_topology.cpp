#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <numbers>
#include <set>

#include "core/contact/corner_walk.hpp"
#include "core/contact/pair_weight.hpp"
#include "tests/support/bodies.hpp"

using namespace asperity;

namespace {

const ParallelLoops kLoops;

/// Particles one to a triangle, bonded, with general contact on.
struct Bonded : test::BondedBodies {
  Mesh mesh;

  explicit Bonded(const Mesh& m) : test::BondedBodies(test::bonded_bodies(m)), mesh(m) {}

  int contact_between(int a, int b) const {
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      const ContactEdge& e = contacts.edges[c];
      if ((e.left_triangle() == a && e.right_triangle() == b) || (e.left_triangle() == b && e.right_triangle() == a)) {
        return static_cast<int>(c);
      }
    }
    return -1;
  }

  /// Breaks the contact between two triangles; weight 1: just now, 0: released.
  void break_contact(int a, int b, double weight) {
    const int c = contact_between(a, b);
    REQUIRE(c >= 0);
    contacts.broken_edge(c).break_time = 0.0;
    contacts.broken_edge(c).hand_over.weight = weight;
  }

  void search() { search_pairs(general, contacts, particles, kLoops); }

  /// Weight of the pair of two triangles; -1 where they are not on the list.
  double weight(int a, int b) const {
    for (const MemberPair& pair : general.pairs) {
      const int s = general.members[pair.a].triangle, t = general.members[pair.b].triangle;
      if ((s == a && t == b) || (s == b && t == a)) return pair_weight(general, contacts, pair);
    }
    return -1.0;
  }
};

Mesh wheel(int triangles) {
  test::Bodies bodies;
  bodies.add_wheel({0, 0}, 2.0, triangles);
  Mesh mesh = bodies.mesh;
  for (int t = 0; t < triangles; ++t) mesh.grain[t] = t;
  return mesh;
}

Vec2 edge_end(const Bonded& model, int edge, int end) {
  return model.mesh.vertices[model.mesh.triangles[edge / 3][(edge % 3 + end) % 3]];
}

/// The loops of exposed edges (3 triangle + k) that `next` makes; every one must come back to its start.
std::vector<std::vector<int>> surface_loops(const Bonded& model) {
  std::vector<std::vector<int>> loops;
  std::set<int> seen;
  const auto& members = model.general.members;
  const auto edge_of = [&](int entry) { return 3 * members[entry / 3].triangle + entry % 3; };
  for (int start = 0; start < static_cast<int>(3 * members.size()); ++start) {
    if (members[start / 3].surface[start % 3] < 0 || seen.count(start)) continue;
    std::vector<int> loop;
    int at = start;
    do {
      REQUIRE(seen.insert(at).second);
      loop.push_back(edge_of(at));
      const int next = members[at / 3].next[at % 3];
      REQUIRE(next >= 0);
      REQUIRE(members[next / 3].previous[next % 3] == at);
      REQUIRE(edge_end(model, edge_of(at), 1) == edge_end(model, edge_of(next), 0));
      at = next;
    } while (at != start);
    loops.push_back(loop);
  }
  return loops;
}

std::multiset<std::size_t> sizes(const std::vector<std::vector<int>>& loops) {
  std::multiset<std::size_t> result;
  for (const auto& loop : loops) result.insert(loop.size());
  return result;
}

/// Two triangles of a grid mesh that share an edge between two inner vertices, or one inner and one outer vertex.
std::array<int, 2> neighbours(const Bonded& model, const test::Grid& grid, int outer_ends) {
  const auto outer = [&](int vertex) {
    const int i = vertex % (grid.columns + 1), j = vertex / (grid.columns + 1);
    return i == 0 || j == 0 || i == grid.columns || j == grid.rows;
  };
  for (const ContactEdge& e : model.contacts.edges) {
    const int ends = outer(model.particles.vertex[e.left1]) + outer(model.particles.vertex[e.left2]);
    if (ends == outer_ends) return {e.left_triangle(), e.right_triangle()};
  }
  return {-1, -1};
}

}  // namespace

TEST_CASE("Partners lie across the same edge, and joints are the contacts between them") {
  const Bonded model(test::grid_mesh({6, 5}));
  int outline = 0;
  for (int edge = 0; edge < static_cast<int>(3 * model.mesh.triangles.size()); ++edge) {
    const int partner = model.contacts.partner(edge);
    if (model.contacts.joint(edge) == kOutline) {
      CHECK(partner == -1);
      ++outline;
      continue;
    }
    REQUIRE(partner >= 0);
    CHECK(model.contacts.partner(partner) == edge);
    CHECK(model.contacts.joint(edge) == model.contact_between(edge / 3, partner / 3));
    CHECK(edge_end(model, edge, 0) == edge_end(model, partner, 1));
    CHECK(edge_end(model, edge, 1) == edge_end(model, partner, 0));
  }
  CHECK(outline == 2 * (6 + 5));
}

TEST_CASE("A walk around a vertex goes counter-clockwise through every triangle there, to the outline or back") {
  const Bonded model(test::grid_mesh({6, 5}));
  std::map<int, std::set<int>> corners_at;
  for (int corner = 0; corner < static_cast<int>(3 * model.mesh.triangles.size()); ++corner) {
    corners_at[model.mesh.triangles[corner / 3][corner % 3]].insert(corner);
  }
  double angles = 0.0;
  for (const auto& [vertex, corners] : corners_at) {
    std::size_t longest = 0;
    for (const int start : corners) {
      std::set<int> seen;
      int corner = start;
      while (corner >= 0 && seen.insert(corner).second) {
        REQUIRE(corners.count(corner) == 1);
        const int next = next_corner(model.contacts, corner);
        if (next >= 0) {
          CHECK(model.contacts.joint(arriving_edge(corner)) == model.contact_between(corner / 3, next / 3));
          // The edge that the two share begins at the vertex for the next triangle.
          CHECK(edge_end(model, arriving_edge(corner), 0) == edge_end(model, next, 1));
        }
        corner = next;
      }
      CHECK((corner == start || corner == -1));  // round, or out
      longest = std::max(longest, seen.size());
      angles += corner_angle(model.particles, start);
    }
    CHECK(longest == corners.size());
  }
  CHECK(angles == Approx(std::numbers::pi * static_cast<double>(model.mesh.triangles.size())));
}

TEST_CASE("Triangles of one grain are joined for good") {
  const Bonded model(test::continuum(test::grid_mesh({3, 3})));
  for (int edge = 0; edge < static_cast<int>(3 * model.mesh.triangles.size()); ++edge) {
    const int joint = model.contacts.joint(edge);
    CHECK((joint == kGrain || joint == kOutline));
    if (joint == kGrain) CHECK(model.contacts.partner(model.contacts.partner(edge)) == edge);
  }
}

TEST_CASE("The surface goes on round the outline, round an inner crack, and in and out of a notch") {
  const test::Grid grid{6, 5};
  const std::size_t outline = 2 * (6 + 5);
  Bonded model(test::grid_mesh(grid));
  model.search();
  CHECK(sizes(surface_loops(model)) == std::multiset<std::size_t>{outline});

  Bonded cracked(test::grid_mesh(grid));
  const auto inner = neighbours(cracked, grid, 0);
  cracked.break_contact(inner[0], inner[1], 0.5);
  cracked.search();
  CHECK(sizes(surface_loops(cracked)) == std::multiset<std::size_t>{2, outline});

  Bonded notched(test::grid_mesh(grid));
  const auto outer = neighbours(notched, grid, 1);
  notched.break_contact(outer[0], outer[1], 0.0);
  notched.search();
  CHECK(sizes(surface_loops(notched)) == std::multiset<std::size_t>{outline + 2});

  Bonded loose(test::grid_mesh(grid));
  for (const ContactEdge& e : loose.contacts.edges) {
    if (e.left_triangle() == 20 || e.right_triangle() == 20)
      loose.break_contact(e.left_triangle(), e.right_triangle(), 0.0);
  }
  loose.search();
  const auto loops = surface_loops(loose);
  CHECK(sizes(loops) == std::multiset<std::size_t>{3, 3, outline});
}

TEST_CASE("Exposed edges are of the outline or of a fracture, bonded ones of neither") {
  const test::Grid grid{6, 5};
  Bonded model(test::grid_mesh(grid));
  const auto inner = neighbours(model, grid, 0);
  model.break_contact(inner[0], inner[1], 1.0);
  model.search();
  int counts[3] = {0, 0, 0};
  for (const ContactMember& member : model.general.members) {
    for (int k = 0; k < 3; ++k) {
      ++counts[1 + member.surface[k]];
      const int joint = model.contacts.joint(3 * member.triangle + k);
      const bool broken = joint >= 0 && model.contacts.is_broken(joint);
      CHECK(member.surface[k] == (joint == kOutline ? 0 : broken ? 1 : -1));
    }
  }
  CHECK(counts[1] == 2 * (6 + 5));
  CHECK(counts[2] == 2);
}

namespace {

/// Weights of the six contacts of a wheel, contact i between the triangles i and i + 1; kUnbroken: not broken.
constexpr double kUnbroken = 2.0;
using WheelWeights = std::array<double, 6>;

Bonded broken_wheel(const WheelWeights& weights) {
  Bonded model(wheel(6));
  for (int i = 0; i < 6; ++i) {
    if (weights[i] != kUnbroken) model.break_contact(i, (i + 1) % 6, weights[i]);
  }
  model.search();
  return model;
}

/// Eq. (C46) for two triangles of the wheel, -1 where they are held for good: each takes 60 degrees of the fan.
double expected_weight(const WheelWeights& w, int a, int b) {
  const bool adjacent = (b - a + 6) % 6 == 1 || (a - b + 6) % 6 == 1;
  if (adjacent) {
    const double own = w[(b - a + 6) % 6 == 1 ? a : b];
    return own == kUnbroken ? -1.0 : 1.0 - own;
  }
  double product = 1.0;
  bool handing_over = false;
  for (const auto& [from, to] : {std::array{a, b}, std::array{b, a}}) {
    const int between = (to - from + 6) % 6 - 1;
    if (60.0 * between > 150.0) continue;
    for (int i = from; i != to; i = (i + 1) % 6) {
      if (w[i] == kUnbroken) continue;
      handing_over = true;
      product *= w[i];
    }
  }
  return handing_over ? 1.0 - product : -1.0;
}

}  // namespace

TEST_CASE("What still holds two triangles around a vertex sets the weight of their contact") {
  const double u = kUnbroken;
  // Intact: nothing is on the list.
  CHECK(broken_wheel({u, u, u, u, u, u}).general.pairs.empty());
  // Their own contact hands over: only it counts; the next one but one is reached through it.
  CHECK(broken_wheel({0.3, u, u, u, u, u}).weight(0, 1) == Approx(0.7));
  CHECK(broken_wheel({0.3, 0.9, u, u, u, u}).weight(0, 2) == Approx(1.0 - 0.3 * 0.9));
  // Opposite triangles can meet on both sides.
  CHECK(broken_wheel({0.3, u, u, u, 0.9, u}).weight(0, 3) == Approx(1.0 - 0.3 * 0.9));
  // Released anywhere on the way: full weight; just broken: none yet.
  CHECK(broken_wheel({0.0, 0.9, u, u, u, u}).weight(0, 2) == 1.0);
  CHECK(broken_wheel({1.0, u, u, u, u, u}).weight(0, 1) == 0.0);

  // Opposite ones of fourteen: 154 degrees on either side, too wide to meet through; both ways must let go.
  Bonded wide(wheel(14));
  for (int i = 0; i < 7; ++i) wide.break_contact(i, i + 1, 0.0);
  wide.search();
  CHECK(wide.weight(0, 7) == -1.0);
  for (int i = 7; i < 13; ++i) wide.break_contact(i, (i + 1) % 14, 0.0);
  wide.break_contact(13, 0, 0.4);
  wide.search();
  CHECK(wide.weight(0, 7) == 1.0);

  RandomStream random(5, "wheel weights");
  for (int trial = 0; trial < 300; ++trial) {
    WheelWeights weights;
    for (double& w : weights) {
      const auto kind = random.below(4);
      w = kind < 2 ? kUnbroken : kind == 2 ? 0.0 : random.uniform();
    }
    const Bonded model = broken_wheel(weights);
    for (int a = 0; a < 6; ++a) {
      for (int b = a + 1; b < 6; ++b) {
        CAPTURE(trial, a, b);
        CHECK(model.weight(a, b) == Approx(expected_weight(weights, a, b)));
      }
    }
  }
}

TEST_CASE("The two faces of a re-entrant corner meet once the corner's triangles have let go") {
  Mesh corner = wheel(14);
  corner.triangles.pop_back();
  corner.grain.pop_back();
  Bonded model(corner);
  model.search();
  CHECK(model.weight(0, 12) == -1.0);
  model.break_contact(5, 6, 0.25);
  model.search();
  CHECK(model.weight(0, 12) == Approx(0.75));
  model.break_contact(5, 6, 0.0);
  model.search();
  CHECK(model.weight(0, 12) == 1.0);
}

TEST_CASE("Triangles of one body that meet without a chain between them have full weight at once") {
  // A strip of one cell above another, apart by 0.1 mm: near each other, joined by nothing.
  test::Bodies bodies;
  bodies.add_block({0, 0}, {2, 1, 2.0, 0.0});
  bodies.add_block({0, 2.1}, {2, 1, 2.0, 0.0});
  Bonded model(bodies.mesh);
  model.search();
  CHECK(!model.general.pairs.empty());
  for (const MemberPair& pair : model.general.pairs) {
    CHECK(pair_weight(model.general, model.contacts, pair) == 1.0);
    CHECK(model.particles.grain[model.general.members[pair.a].triangle] !=
          model.particles.grain[model.general.members[pair.b].triangle]);
  }
}
