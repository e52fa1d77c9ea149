#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/geometry/near_boxes.hpp"
#include "tests/support/bodies.hpp"

using namespace asperity;

namespace {

const ParallelLoops kLoops;
constexpr double kPenalty = 2000.0;  // MPa/mm

using Corners = std::array<Vec2, 3>;

Corners random_corners(RandomStream& random, double size) {
  const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
  Corners corners;
  for (int k = 0; k < 3; ++k) {
    const double at = angle + 2.0 * std::numbers::pi * (k + random.uniform(-0.3, 0.3)) / 3.0;
    corners[k] = test::turned({size * random.uniform(0.5, 1.0), 0.0}, at);
  }
  return corners;
}

/// Two loose triangles that may touch each other alone.
struct Couple {
  System system;
  std::vector<Vec2> forces = std::vector<Vec2>(6);

  Couple(const Corners& a, const Corners& b, SurfaceLaw surface, double damping_ratio = 0.0) {
    test::Bodies bodies;
    bodies.add({a.begin(), a.end()}, {{0, 1, 2}});
    bodies.add({b.begin(), b.end()}, {{0, 1, 2}});
    test::BodyMaterial material;
    material.surface = surface;
    material.damping_ratio = damping_ratio;
    system = test::make_bodies(bodies, material, 0.3);
  }

  /// Forces of the contact alone at the present positions, as of a pair that met in the open: without a seat.
  const std::vector<Vec2>& contact_forces() {
    const std::vector<int>& slot_of_edge = system.contacts.slot_of_edge;
    std::vector<Vec2> slots(2 * system.contacts.slot_count());
    search_pairs(system.general, system.contacts, system.particles, kLoops);
    for (MemberPair& pair : system.general.pairs) pair.seat = 0.0;
    update_general_contacts(system.general, system.contacts, system.particles, system.time_step, kLoops,
                            {slots, slot_of_edge, 0});
    for (int corner = 0; corner < 6; ++corner) forces[corner] = slots[2 * slot_of_edge[corner]];
    return forces;
  }
  double energy() {
    contact_forces();
    return general_contact_energies(system.general, kLoops).normal;
  }
  PresentTriangle present(int t) const {
    return present_triangle(system.particles.shape(t), system.particles.corners(t));
  }
};

/// A couple that overlaps at random, both triangles strained by up to 5 %.
Couple random_couple(RandomStream& random, SurfaceLaw surface, double damping_ratio = 0.0) {
  while (true) {
    Corners a = random_corners(random, 2.0), b = random_corners(random, 2.0);
    const Vec2 apart{random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5)};
    for (Vec2& v : b) v += apart;
    Couple couple(a, b, surface, damping_ratio);
    for (Vec2& x : couple.system.particles.position) {
      x += Vec2{random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05)};
    }
    if (couple.energy() > 1e-6) return couple;
  }
}

/// Integral of Eq. (C40) over the rest area of triangle t where it lies in the other one, by the midpoint
/// rule on n x n cells of each half of the unit square of (1 - s) and t.
double sampled_potential(const Couple& couple, int t, int n) {
  const PresentTriangle in = couple.present(t), other = couple.present(1 - t);
  const auto least_depth = [](const PresentTriangle& triangle, Vec2 x) {
    return std::min({triangle.depth(0, x), triangle.depth(1, x), triangle.depth(2, x)});
  };
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      // A point of the unit square, folded over the diagonal.
      double u = (i + 0.5) / n, v = (j + 0.5) / n;
      if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
      const Vec2 x = in.x[0] + u * (in.x[1] - in.x[0]) + v * (in.x[2] - in.x[0]);
      if (least_depth(other, x) <= 0.0) continue;
      const double depth = least_depth(in, x);
      sum += depth + couple.system.general.stiffening * depth * depth * depth;
    }
  }
  return sum * couple.system.particles.shape(t).area / (n * n);
}

}  // namespace

TEST_CASE("Forces of two overlapping triangles are the exact gradient of their potential") {
  RandomStream random(1, "gradient");
  const double h = 1e-5;
  double worst = 0;
  for (int trial = 0; trial < 300; ++trial) {
    Couple couple = random_couple(random, {0.0, kPenalty, kPenalty});
    const std::vector<Vec2> forces = couple.contact_forces();
    double size = 0;
    for (Vec2 f : forces) size = std::max(size, norm(f));
    for (int i = 0; i < 6; ++i) {
      for (double Vec2::*component : {&Vec2::x, &Vec2::y}) {
        double& x = couple.system.particles.position[i].*component;
        const double at = x;
        x = at + h;
        const double up = couple.energy();
        x = at - h;
        const double down = couple.energy();
        x = at;
        const double error = std::abs(forces[i].*component + (up - down) / (2.0 * h)) / (size + kPenalty * h);
        worst = std::max(worst, error);
      }
    }
  }
  // The force has kinks where corners pass edges: there central differences are off by half its change over h.
  CHECK(worst < 1e-5);
  WARN("largest error of a force " << worst << " of the largest force");
}

TEST_CASE("The potential agrees with a quadrature that knows nothing of polygons") {
  RandomStream random(2, "quadrature");
  double worst = 0;
  for (int trial = 0; trial < 40; ++trial) {
    Couple couple = random_couple(random, {0.0, kPenalty, kPenalty});
    if (couple.energy() < 1.0) continue;  // too small an overlap for the cells
    const double sampled = 0.5 * kPenalty * (sampled_potential(couple, 0, 600) + sampled_potential(couple, 1, 600));
    worst = std::max(worst, std::abs(sampled / couple.energy() - 1.0));
  }
  // Cells cut by the overlap's outline: about a hundredth of the cells inside, half of them counted wrongly either way.
  CHECK(worst < 5e-3);
  WARN("largest difference " << worst);
}

TEST_CASE("A flat contact of depth d and length l stores k d^2 l / 2 and pushes with k d l") {
  for (double depth : {1e-3, 1e-4}) {
    const double length = 2.0;
    const Corners below{{{0, 0}, {length, 0}, {0.9, 1.7}}}, above{{{0, 0}, {-length, 0}, {-1.2, -1.6}}};
    Corners a = above, b = below;
    for (Vec2& v : a) v += Vec2{length, depth};  // its flat side lies `depth` above the other's
    Couple couple(a, b, {0.0, kPenalty, kPenalty});
    const double energy = couple.energy();
    Vec2 sum;
    for (int i = 0; i < 3; ++i) sum += couple.forces[i];
    // Next to the ends of the side other edges are nearer: a share of a few depths in the length.
    CHECK(energy == Approx(0.5 * kPenalty * depth * depth * length).epsilon(3.0 * depth / length));
    CHECK(-sum.y == Approx(kPenalty * depth * length).epsilon(3.0 * depth / length));
    CHECK(std::abs(sum.x) < 3.0 * depth / length * kPenalty * depth * length);
  }
}

TEST_CASE("Normal, friction and damping forces of a pair carry no net force and no net moment") {
  RandomStream random(3, "momentum");
  double worst = 0;
  for (int trial = 0; trial < 300; ++trial) {
    Couple couple = random_couple(random, {0.7, kPenalty, 0.6 * kPenalty}, 0.3);
    for (Vec2& v : couple.system.particles.velocity) v = {1e4 * random.normal(), 1e4 * random.normal()};
    couple.system.particles.position[0] += Vec2{1e-3, 0};
    const auto& forces = couple.contact_forces();
    Vec2 sum;
    double moment = 0, size = 0, moment_size = 0;
    for (int i = 0; i < 6; ++i) {
      const Vec2 x = couple.system.particles.position[i];
      sum += forces[i];
      moment += cross(x, forces[i]);
      size += norm(forces[i]);
      moment_size += norm(x) * norm(forces[i]);
    }
    worst = std::max({worst, norm(sum) / size, std::abs(moment) / moment_size});
  }
  CHECK(worst < 1e-13);
  WARN("largest net force or moment " << worst);
}

TEST_CASE("Forces are continuous along random paths of corner past corner") {
  RandomStream random(4, "passages");
  double worst = 0;
  for (int trial = 0; trial < 200; ++trial) {
    Corners a = random_corners(random, 2.0), b = random_corners(random, 2.0);
    Couple couple(a, b, {0.0, kPenalty, kPenalty});
    auto& x = couple.system.particles.position;
    // Corner 3 of the path passes corner 0 within a hundredth of a millimetre, in a random direction.
    const Vec2 miss{random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01)};
    const Vec2 direction = test::turned({1.0, 0.0}, random.uniform(0.0, 2.0 * std::numbers::pi));
    const Vec2 shift = a[0] - b[0] + miss;
    const auto largest_jump = [&](int steps) {
      std::vector<Vec2> before;
      double jump = 0;
      for (int i = 0; i <= steps; ++i) {
        const double s = 0.1 * (2.0 * i / steps - 1.0);
        for (int k = 0; k < 3; ++k) x[3 + k] = b[k] + shift + s * direction;
        const std::vector<Vec2> forces = couple.contact_forces();
        for (std::size_t k = 0; k < before.size(); ++k) jump = std::max(jump, norm(forces[k] - before[k]));
        before = forces;
      }
      return jump;
    };
    const double coarse = largest_jump(500), fine = largest_jump(1000);
    // The stiffness is at most the penalty times the lengths inside, which the path bounds; no jump survives halving.
    if (coarse > 1e-9) worst = std::max(worst, fine / coarse);
  }
  CHECK(worst < 0.75);
  WARN("largest change in half a step over that in a whole one " << worst);
}

TEST_CASE("A pair that begins to meet overlapped takes its seat there, and presses only beyond it") {
  RandomStream random(5, "seats");
  int tried = 0;
  while (tried < 100) {
    Couple couple = random_couple(random, {0.0, kPenalty, kPenalty});
    GeneralContacts& general = couple.system.general;
    const Vec2 middle_a = (1.0 / 3.0) * (couple.present(0).x[0] + couple.present(0).x[1] + couple.present(0).x[2]);
    const Vec2 middle_b = (1.0 / 3.0) * (couple.present(1).x[0] + couple.present(1).x[1] + couple.present(1).x[2]);
    general.pairs.clear();
    general.touches.clear();
    const auto force = [&] {
      std::vector<Vec2> slots(2 * couple.system.contacts.slot_count());
      update_general_contacts(general, couple.system.contacts, couple.system.particles, couple.system.time_step, kLoops,
                              {slots, couple.system.contacts.slot_of_edge, 0});
      double largest = 0.0;
      for (const Vec2& f : slots) largest = std::max(largest, norm(f));
      return largest;
    };
    general.search_due = 1;
    const double first = force();
    REQUIRE(general.pairs.size() == 1);
    if (general.pairs[0].seat == 0.0) continue;  // overlapped by less than the play
    ++tried;
    CHECK(first < 1e-9);  // N per mm, where unseated pairs of this kind press with up to some hundred
    CHECK(general_contact_energies(general, kLoops).normal < 1e-9);
    const double seat = general.pairs[0].seat;
    const Vec2 away = middle_b - middle_a;
    for (int k = 3; k < 6; ++k) couple.system.particles.position[k] += (1e-3 / norm(away)) * away;
    force();
    CHECK(general.pairs[0].seat <= seat);
    for (int k = 3; k < 6; ++k) couple.system.particles.position[k] += (1e2 / norm(away)) * away;
    CHECK(force() == 0.0);  // parted: the seat is forgotten
    CHECK(general.pairs[0].seat == kUnseated);
  }
}

TEST_CASE("Near boxes: the same pairs as brute force, whatever the boxes' sizes") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    RandomStream random(seed, "boxes");
    std::vector<Box> boxes;
    for (int i = 0; i < 200; ++i) {
      const double size = i % 20 == 0 ? 5.0 : 0.3;
      const Vec2 low{random.uniform(0.0, 10.0), random.uniform(0.0, 10.0)};
      boxes.push_back({low, low + Vec2{size * random.uniform(), size * random.uniform()}});
    }
    boxes.push_back({boxes[0].high, boxes[0].high});  // touches in one point
    std::vector<std::array<int, 2>> expected;
    for (int i = 0; i < static_cast<int>(boxes.size()); ++i) {
      for (int j = i + 1; j < static_cast<int>(boxes.size()); ++j) {
        const Box &p = boxes[i], &q = boxes[j];
        if (p.low.x <= q.high.x && q.low.x <= p.high.x && p.low.y <= q.high.y && q.low.y <= p.high.y) {
          expected.push_back({i, j});
        }
      }
    }
    CHECK(near_boxes(boxes) == expected);
  }
}
