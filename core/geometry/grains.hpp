#pragma once
#include <array>
#include <vector>

#include "core/base/random.hpp"
#include "core/geometry/outline.hpp"
#include "core/geometry/points.hpp"

namespace asperity {

/// A corner of grains: inside, or on the outline.
struct GrainCorner {
  Vec2 at;
  int side = -1;       ///< Of the outline; -1 inside.
  double along = 0.0;  ///< Arc length on that side, mm.
  bool fixed = false;  ///< A corner of the outline.
};

/// The borders between grains as a plane graph.
struct GrainBorders {
  std::vector<GrainCorner> corners;
  std::vector<std::array<int, 2>> inner;  ///< Straight borders between two grains: corner indices.
  std::vector<int> loop;                  ///< Corners on the outline, counter-clockwise.
};

/// Grain centres, Eq. (G4), evened out by `lloyd_steps` steps of Eq. (G5): few steps leave them irregular.
std::vector<Vec2> grain_centres(const Outline& outline, double grain_size_mm, int lloyd_steps, RandomStream& random);

/// The centres' Voronoi cells cut off at a convex outline; borders shorter than shortest_mm are collapsed. Throws
/// Error(numerical) where a cell's border ends neither inside nor on the outline.
GrainBorders grain_borders(const Outline& outline, const std::vector<Vec2>& centres, double reach_mm,
                           double shortest_mm);

/// The borders as fixed points about edge_mm apart, joined by segments.
PointSet split_borders(const GrainBorders& borders, const Outline& outline, double edge_mm);

}  // namespace asperity
