#pragma once
#include <vector>

#include "render/drawing.hpp"

namespace asperity::render {

/// The drawing's shapes, without its texts, as triangles in painter's order (pixels, y downwards).
std::vector<Triangle> tessellate(const Drawing& drawing);

/// The drawn parts of a line of dashes; a solid line comes back whole. Points nearer than half a pixel are left out.
std::vector<std::vector<Vec2>> dashes(const Polyline& line);

}  // namespace asperity::render
