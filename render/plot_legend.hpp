#pragma once
#include "render/plots.hpp"

namespace asperity::render {

/// The line of a series, and the paler fill of its area.
struct SeriesLook {
  Stroke stroke;
  Colour fill;
};

SeriesLook look_of(const Plot& plot, std::size_t series);

/// Draws the legend in rows from the top of `room` and returns where the last row ends, in pixels.
double draw_plot_legend(Drawing& drawing, const Plot& plot, const Box& room);

}  // namespace asperity::render
