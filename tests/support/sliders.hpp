#pragma once
#include <cmath>
#include <vector>

#include "tests/support/bodies.hpp"

/// A slider on a long surface with irregular edges, drawn along at a given velocity.
namespace asperity::test {

/// Lengths of edges between 0.6 and 1.4 times `mean`, mm.
inline std::vector<double> irregular_lengths(int count, double mean, std::uint64_t seed) {
  RandomStream random(seed, "irregular edges");
  std::vector<double> lengths;
  for (int i = 0; i < count; ++i) lengths.push_back(mean * random.uniform(0.6, 1.4));
  return lengths;
}

/// Adds rows of cells, each cut along its diagonal, whose columns have the given widths; the lower left corner lies at
/// `origin`. Returns the body's number.
inline int add_strip(Bodies& bodies, Vec2 origin, const std::vector<double>& widths, int rows, double height) {
  const int columns = static_cast<int>(widths.size());
  std::vector<Vec2> vertices;
  std::vector<std::array<int, 3>> triangles;
  for (int j = 0; j <= rows; ++j) {
    double x = 0.0;
    for (int i = 0; i <= columns; ++i) {
      vertices.push_back(origin + Vec2{x, height * j / rows});
      if (i < columns) x += widths[i];
    }
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int a = j * (columns + 1) + i, d = a + columns + 1;
      if ((i + j) % 2 == 0) {
        triangles.insert(triangles.end(), {{a, a + 1, d + 1}, {a, d + 1, d}});
      } else {
        triangles.insert(triangles.end(), {{a, a + 1, d}, {a + 1, d + 1, d}});
      }
    }
  }
  return bodies.add(vertices, triangles);
}

/// Nodes that are drawn along x with a given velocity and free along y.
struct Drive {
  std::vector<int> nodes;
  double resistance = 0;  ///< Of the rest of the model against the drive in the last step, along x, N per mm.
};

/// The body's nodes above a height at rest.
inline Drive drive_above(const System& system, int body, double y) {
  Drive drive;
  for (int node : nodes_of(system, body)) {
    if (system.particles.reference(node).y > y) drive.nodes.push_back(node);
  }
  return drive;
}

/// One step in which the drive's nodes take the velocity `v` along x.
inline void advance_driven(System& system, Drive& drive, double v, const ParallelLoops& loops) {
  compute_forces(system, loops);
  update_velocities(system, loops);
  drive.resistance = 0.0;
  for (int node : drive.nodes) {
    drive.resistance -= internal_force(system, node).x;
    system.particles.velocity[node].x = v;
  }
  update_positions(system, loops);
}

/// Friction of all general contacts of a body, N per mm of thickness.
struct FrictionForce {
  Vec2 force;        ///< On the body.
  double limit = 0;  ///< What its component along x can be at most: each entry's mu n on its own edge.
};

inline FrictionForce friction_on(const System& system, int body, double mu) {
  const GeneralContacts& g = system.general;
  FrictionForce sum;
  for (const Touch& touch : g.touches) {
    const MemberPair& pair = g.pairs[touch.pair];
    for (int i = 0; i < 6; ++i) {
      const int own = i < 3 ? pair.a : pair.b, other = i < 3 ? pair.b : pair.a, k = i % 3;
      if (touch.parts[i].m0 <= 0.0 || g.members[own].surface[k] < 0) continue;
      const Vec2 along = g.frames[own].x[(k + 1) % 3] - g.frames[own].x[k];
      const EdgeFriction& f = touch.friction[i];
      const double against = 0.5 * touch.k_s * f.length * f.slip / norm(along);
      const bool mine = system.particles.grain[g.members[own].triangle] == body;
      sum.force += (mine ? -against : against) * along;
      const double pressing = 0.5 * touch.weight * touch.k_n * g.frames[other].inverse_jacobian * touch.parts[i].m0;
      sum.limit += mu * pressing * std::abs(along.x);
    }
  }
  return sum;
}

}  // namespace asperity::test
