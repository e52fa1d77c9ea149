#pragma once
#include <vector>

#include "core/geometry/grains.hpp"

/// The steps that turn raw Voronoi borders into a graph without short borders.
namespace asperity {

/// Adds the outline's corners, orders all corners on the outline counter-clockwise into `loop` and merges those closer
/// than shortest_mm (to the outline's own corner where one is there).
void close_along_outline(GrainBorders& borders, const Outline& outline, double shortest_mm);

/// Merges the ends of inner borders shorter than shortest_mm, shortest first: onto the outline if one end lies there,
/// else in the middle. Grains that lose all but two borders vanish.
void collapse_short(GrainBorders& borders, double shortest_mm);

/// Builds the point set of split borders, sharing the corners' points.
class BorderSplitter {
 public:
  BorderSplitter(const GrainBorders& borders, double edge_mm);
  void add_line(int from, int to);
  /// Along the outline; the next corner may stand at the start of the next side.
  void add_arc(int from, int to, const Outline& outline);
  PointSet take() { return std::move(set_); }

 private:
  int point_of(int corner);
  template <class At>
  void add_pieces(int from, int to, double length, const At& at);

  const GrainBorders& borders_;
  double edge_mm_;
  std::vector<int> point_;
  PointSet set_;
};

}  // namespace asperity
