#pragma once
#include <vector>

#include "core/geometry/outline.hpp"
#include "core/geometry/points.hpp"
#include "core/geometry/triangulation.hpp"

namespace asperity {

/// When to stop relaxing.
struct RelaxationGoal {
  double edge_deviation = 0.1;  ///< Standard deviation of the edge lengths over their mean, at most.
  double angle_min_deg = 25.0;  ///< Smallest angle, at least.
  int iterations = 200;         ///< At most.
  double mending_from = 1.15;  ///< Deviation over the one asked for from which on poor triangles are mended one by one.
};

/// Edge lengths (mm), Eq. (G8), and smallest angle (degrees), Eq. (G9), of a triangulated point set; angles in sharp
/// corners are not counted.
struct Regularity {
  double edge_mean_mm = 0.0, edge_deviation_mm = 0.0, angle_min_deg = 180.0;
};

struct Relaxed {
  Triangulation mesh;
  Regularity regularity;
};

Regularity measure_regularity(const PointSet& set, const Triangulation& mesh);

/// Moves the points as if every edge were a spring, Eq. (G2) and Eq. (G3), with a new Delaunay triangulation after
/// every move, until the goal is met or its iterations are used up; the caller checks which.
Relaxed relax(PointSet& set, const Outline& outline, const RelaxationGoal& goal);

/// Removes free points that are squeezed flat, from each triangle with an angle below angle_min_deg the one at its
/// largest angle, and those that no triangle has. Returns whether there were any. Other points keep their numbers if
/// free ones stand last.
bool drop_squeezed(PointSet& set, const Triangulation& mesh, double angle_min_deg);

/// Moves every free point to the middle of the triangles around it, Eq. (G7), `iterations` times, and keeps the best
/// smallest angle met on the way. Unlike springs it never pushes a point across a segment: for small, fixed pieces.
Relaxed smooth(PointSet& set, int iterations);

}  // namespace asperity
