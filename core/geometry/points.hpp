#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/base/random.hpp"
#include "core/base/vec2.hpp"
#include "core/geometry/outline.hpp"

namespace asperity {

/// How a mesh point may move while the mesh is relaxed.
enum class Freedom : std::uint8_t { fixed, sliding, free };

struct MeshPoint {
  Vec2 at;
  Freedom freedom = Freedom::free;
  int side = -1;       ///< Sliding points: the outline's side...
  double along = 0.0;  ///< ...and the arc length on it, mm.
  bool sharp = false;  ///< A corner sharper than triangles may be: angles at it are given, and do not count.
};

/// Points to be triangulated and the segments (index pairs) that must become edges.
struct PointSet {
  std::vector<MeshPoint> points;
  std::vector<std::array<int, 2>> segments;
};

/// Fixed points in the outline's corners and sliding points between them, about edge_mm apart with a relative scatter,
/// joined by segments; counter-clockwise.
PointSet place_on_outline(const Outline& outline, double edge_mm, double scatter, RandomStream& random);

/// Arc lengths of the ends of that many pieces of a line, from 0 to `length`, with a relative scatter of their lengths.
std::vector<double> random_cuts(double length, int pieces, double scatter, RandomStream& random);

/// Marks the points where two segments meet at less than angle_deg.
void mark_sharp_corners(PointSet& set, double angle_deg);

/// Up to `count` random points inside the closed polygon, no two closer than spacing_mm, also not to a point already
/// in the set. Fewer where no more fit. Throws darts on a hash grid: O(count).
void throw_darts(PointSet& set, const std::vector<Vec2>& polygon, int count, double spacing_mm, RandomStream& random);

std::vector<Vec2> positions(const PointSet& set);

/// Even-odd rule.
bool contains(const std::vector<Vec2>& polygon, Vec2 p);

}  // namespace asperity
