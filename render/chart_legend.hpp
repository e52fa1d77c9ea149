#pragma once
#include "render/charts.hpp"

namespace asperity::render {

/// Draws the labels of all charts' layers, each once, in rows from the top of `room`; returns where the last row ends,
/// in pixels, or the room's top if there is no label.
double draw_chart_legend(Drawing& drawing, const std::vector<Chart>& charts, const Box& room);

}  // namespace asperity::render
