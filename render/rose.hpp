#pragma once
#include <vector>

#include "render/drawing.hpp"

namespace asperity::render {

/// Shares of length by orientation as a rose: bin i of n holds the angles from -90 + 180 i/n degrees on, from the
/// vertical and positive to the right. Each bin is a wedge and its mirror about the centre; areas are in proportion to
/// shares, and a share of `outer` reaches the ring at `radius` (pixels). Shares that are not finite give a ring alone.
struct Rose {
  std::vector<double> shares;
  double outer = 1;
};
void draw_rose(Drawing& drawing, Vec2 centre, double radius, const Rose& rose);

}  // namespace asperity::render
