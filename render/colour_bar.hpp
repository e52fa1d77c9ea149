#pragma once
#include "render/axes.hpp"
#include "render/charts.hpp"

namespace asperity::render {

/// The room a field's colour bar takes beside a frame, in pixels.
double colour_bar_room(const FieldLayer& field, const AxesStyle& style);

/// Draws the bar beside the right side of a frame, as high as the frame: a band's colour each, levels and unit.
void draw_colour_bar(Drawing& drawing, const Box& frame, const FieldLayer& field, const AxesStyle& style);

}  // namespace asperity::render
