#pragma once
#include <algorithm>
#include <ctime>
#include <limits>
#include <numbers>

#include "tests/support/bodies.hpp"

/// Loose triangles scattered over the plane, for the search of general contacts.
namespace asperity::test {

/// `count` triangles of random shape, each its own grain with its own vertices, about one to a cell of a square grid
/// and wide enough to meet the next ones. `reversed` numbers the same triangles backwards.
inline BondedBodies scattered_triangles(int count, std::uint64_t seed, bool reversed = false) {
  RandomStream random(seed, "scattered triangles");
  const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
  Mesh mesh;
  mesh.vertices.resize(3 * static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const Vec2 centre{1.2 * (i % columns) + random.uniform(-0.5, 0.5), 1.2 * (i / columns) + random.uniform(-0.5, 0.5)};
    const double size = random.uniform(0.4, 1.0), angle = random.uniform(0.0, 2.0 * std::numbers::pi);
    const int t = reversed ? count - 1 - i : i;
    for (int k = 0; k < 3; ++k) {
      const double corner = angle + 2.0 * std::numbers::pi * (k + random.uniform(-0.2, 0.2)) / 3.0;
      mesh.vertices[3 * t + k] = centre + turned({size, 0.0}, corner);
    }
  }
  for (int t = 0; t < count; ++t) {
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    mesh.grain.push_back(t);
  }
  return bonded_bodies(mesh);
}

/// Processor time of a search over the number of triangles, the best of three, s.
inline double search_seconds_per_triangle(int count) {
  BondedBodies model = scattered_triangles(count, 1);
  double best = std::numeric_limits<double>::max();
  for (int i = 0; i < 3; ++i) {
    const std::clock_t start = std::clock();
    search_pairs(model.general, model.contacts, model.particles, ParallelLoops());
    best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return best / count;
}

}  // namespace asperity::test
