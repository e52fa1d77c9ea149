#pragma once
#include <string>

#include "render/drawing.hpp"

namespace asperity::render {

inline constexpr double kFigureMargin = 36;  ///< Around everything in a figure, pixels.

/// Draws a figure's title over its whole width; returns where what follows may begin, in pixels.
double draw_title(Drawing& drawing, const std::string& title);

/// Draws the caption in lines at the figure's foot; returns where it begins, in pixels.
double draw_caption(Drawing& drawing, const std::string& caption);

}  // namespace asperity::render
