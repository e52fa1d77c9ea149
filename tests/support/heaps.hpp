#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/bodies.hpp"

/// Random heaps: pieces of one to eight triangles in a held box, thrown about under gravity.
namespace asperity::test {

/// Body 0 is the box, held; the others are the pieces.
struct Heap {
  double side = 0;  ///< Of the box, inside, mm: from (0, 0).
  int pieces = 0;
  int corner_starts = 0;  ///< Pieces that start with a corner exactly on another body's corner.
  System system;
};

/// A ring of triangles around the square (0, 0)-(side, side), `cells` to a side; its walls are a third of the side.
inline void add_box(Bodies& bodies, double side, int cells) {
  const Vec2 corner[4] = {{0, 0}, {side, 0}, {side, side}, {0, side}};
  const Vec2 middle{0.5 * side, 0.5 * side};
  const int n = 4 * cells;
  std::vector<Vec2> vertices;
  for (int i = 0; i < n; ++i) {
    const Vec2 from = corner[i / cells], to = corner[(i / cells + 1) % 4];
    vertices.push_back(from + (static_cast<double>(i % cells) / cells) * (to - from));
  }
  for (int i = 0; i < n; ++i) vertices.push_back(middle + (5.0 / 3.0) * (vertices[i] - middle));
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    triangles.push_back({n + i, n + j, j});
    triangles.push_back({n + i, j, i});
  }
  bodies.add(vertices, triangles);
}

/// Vertices and triangles of one piece around the origin.
struct Piece {
  std::vector<Vec2> vertices;
  std::vector<std::array<int, 3>> triangles;
};

/// One triangle of random shape.
inline Piece random_triangle(RandomStream& random, double size) {
  Piece piece;
  for (int i = 0; i < 3; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + random.uniform(-0.25, 0.25)) / 3.0;
    piece.vertices.push_back(turned({size * random.uniform(0.6, 1.0), 0.0}, angle));
  }
  piece.triangles = {{0, 1, 2}};
  return piece;
}

/// A star of three to eight triangles around a centre; the random radii make most of them concave.
inline Piece random_star(RandomStream& random, double size) {
  const int corners = 3 + static_cast<int>(random.below(6));
  Piece piece{{{0, 0}}, {}};
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + random.uniform(-0.15, 0.15)) / corners;
    piece.vertices.push_back(turned({size * random.uniform(0.55, 1.0), 0.0}, angle));
    piece.triangles.push_back({0, 1 + i, 1 + (i + 1) % corners});
  }
  return piece;
}

/// A bent strip of two to eight triangles, concave on its inside.
inline Piece random_strip(RandomStream& random, double size) {
  const int cells = 1 + static_cast<int>(random.below(4));
  const double bend = random.uniform(-0.5, 0.5), width = 0.7 * size;
  Piece piece;
  Vec2 at{0, 0};
  double angle = 0.0;
  for (int i = 0; i <= cells; ++i) {
    piece.vertices.push_back(at + turned({0.0, -0.5 * width}, angle));
    piece.vertices.push_back(at + turned({0.0, 0.5 * width}, angle));
    at += turned({width * random.uniform(0.8, 1.2), 0.0}, angle);
    angle += bend;
  }
  for (int i = 0; i < cells; ++i) {
    const int a = 2 * i;
    piece.triangles.push_back({a, a + 2, a + 3});
    piece.triangles.push_back({a, a + 3, a + 1});
  }
  return piece;
}

inline Piece random_piece(RandomStream& random) {
  const double size = random.uniform(0.9, 2.2);
  const auto kind = random.below(3);
  Piece piece = kind == 0   ? random_triangle(random, size)
                : kind == 1 ? random_star(random, size)
                            : random_strip(random, size);
  const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
  for (Vec2& v : piece.vertices) v = turned(v, angle);
  return piece;
}

inline PresentTriangle at_rest(Vec2 a, Vec2 b, Vec2 c) { return present_triangle(triangle_shape(a, b, c), {a, b, c}); }

inline PresentTriangle at_rest(const std::vector<Vec2>& v, const std::array<int, 3>& t) {
  return at_rest(v[t[0]], v[t[1]], v[t[2]]);
}

/// Whether a piece is clear of all triangles so far, or no more than touches them.
inline bool is_clear(const Mesh& mesh, const Piece& piece) {
  for (const auto& mine : piece.triangles) {
    const PresentTriangle a = at_rest(piece.vertices, mine);
    for (const auto& other : mesh.triangles) {
      const PresentTriangle b = at_rest(mesh.vertices, other);
      if (overlap_potential(a, b.x) > 1e-14 || overlap_potential(b, a.x) > 1e-14) return false;
    }
  }
  return true;
}

/// Puts the piece somewhere in the box, or with one corner exactly on a corner that is already there.
inline bool place(RandomStream& random, const Mesh& mesh, double side, bool at_corner, Piece& piece) {
  for (int attempt = 0; attempt < 60; ++attempt) {
    const Vec2 mine = at_corner ? piece.vertices[random.below(piece.vertices.size())] : Vec2{0, 0};
    const Vec2 target = at_corner ? mesh.vertices[random.below(mesh.vertices.size())]
                                  : Vec2{random.uniform(0.0, side), random.uniform(0.0, side)};
    Piece placed = piece;
    bool inside = true;
    for (Vec2& v : placed.vertices) {
      v = v == mine && at_corner ? target : v + (target - mine);
      inside = inside && v.x >= 0.0 && v.y >= 0.0 && v.x <= side && v.y <= side;
    }
    if (!inside || !is_clear(mesh, placed)) continue;
    piece = placed;
    return true;
  }
  return false;
}

/// Velocities of translation and rotation for one piece, mm/s at most about `speed`.
inline void throw_piece(RandomStream& random, System& system, int body, double speed) {
  const BodyMotion motion = motion_of(system, body);
  const Vec2 velocity{speed * random.uniform(-1.0, 1.0), speed * random.uniform(-1.0, 1.0)};
  const double spin = 0.5 * speed * random.uniform(-1.0, 1.0);
  for (int node : nodes_of(system, body)) {
    const Vec2 arm = system.particles.position[node] - motion.centre;
    system.particles.velocity[node] = velocity + spin * Vec2{-arm.y, arm.x};
  }
}

/// Heap number `seed`: everything in it is drawn from one named stream.
inline Heap random_heap(std::uint64_t seed, double safety = 0.3) {
  RandomStream random(seed, "heap");
  Heap heap;
  heap.side = random.uniform(9.0, 13.0);
  Bodies bodies;
  add_box(bodies, heap.side, 2 + static_cast<int>(random.below(3)));
  const int wanted = 4 + static_cast<int>(random.below(7));
  for (int i = 0; i < wanted; ++i) {
    Piece piece = random_piece(random);
    const bool at_corner = random.uniform() < 0.3;
    if (!place(random, bodies.mesh, heap.side, at_corner, piece)) continue;
    bodies.add(piece.vertices, piece.triangles);
    heap.corner_starts += at_corner;
  }
  heap.pieces = bodies.count - 1;
  BodyMaterial material;
  material.poissons_ratio = random.uniform(0.0, 0.35);
  const double penalty = material.youngs_modulus * std::exp(random.uniform(std::log(0.7), std::log(7.0)));
  material.surface = {random.uniform() < 0.15 ? 0.0 : random.uniform(0.0, 1.2), penalty,
                      penalty * random.uniform(0.3, 1.0)};
  if (random.uniform() < 0.3) material.damping_ratio = random.uniform(0.05, 0.4);
  heap.system = make_bodies(bodies, material, safety);
  hold(heap.system, 0);
  const double speed = random.uniform(1000.0, 9000.0);
  for (int body = 1; body <= heap.pieces; ++body) throw_piece(random, heap.system, body, speed);
  heap.system.body_acceleration = turned({0.0, -random.uniform(2e6, 1.5e7)}, random.uniform(-0.5, 0.5));
  book_initial_kinetic_energy(heap.system);
  return heap;
}

}  // namespace asperity::test
