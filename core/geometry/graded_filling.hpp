#pragma once
#include <vector>

#include "core/base/random.hpp"
#include "core/base/vec2.hpp"
#include "core/geometry/points.hpp"
#include "core/geometry/relaxation.hpp"

namespace asperity {

/// Edge lengths of a part that is fine along one line and coarse away from it, mm.
struct Grading {
  std::vector<Vec2> fine;  ///< Points of the fine line.
  double fine_edge_mm;
  double coarse_edge_mm;
  /// Eq. (G12).
  double edge_at(Vec2 p) const;
};

/// Points and triangles of a graded part.
struct GradedFilling {
  PointSet set;  ///< First grading.fine, in its order.
  Relaxed filled;
};

/// Fills the polygon whose border runs along the points of grading.fine and then through `outer`, its other corners.
/// The fine line gets no further point; all of the border is followed exactly. Smallest angle about 25 degrees, except
/// in corners that are sharper: the caller checks.
GradedFilling fill_graded(const Grading& grading, const std::vector<Vec2>& outer, RandomStream& random);

}  // namespace asperity
