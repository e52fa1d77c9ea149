#pragma once
#include "core/measurement/frame.hpp"
#include "render/drawing.hpp"

namespace asperity::render {

/// Whether the frame has contacts that were open before the test.
bool has_defects(const Frame& frame);

/// The lines of cracks and what they stand for, in a row from `at` (the lines' height) on, smaller where `width` pixels
/// are too few; defects only where there are some.
void draw_crack_legend(Drawing& drawing, bool defects, Vec2 at, double width, double unit);

}  // namespace asperity::render
