#pragma once
#include <string>
#include <vector>

#include "core/measurement/frame.hpp"
#include "render/drawing.hpp"
#include "render/field.hpp"
#include "render/rose.hpp"

namespace asperity::render {

/// One specimen of a grid and what stands under it: a heading in bold, then lines, which are wrapped.
struct PatternPanel {
  Frame frame;
  std::string heading;
  std::vector<std::string> lines;
  Rose rose;  ///< Of its cracks; without shares: none.
};

/// Specimens side by side, in rows where there are many: one scale (mm per pixel), one range of colours, one legend.
struct PatternGrid {
  std::string title, subtitle;
  Field field = Field::cracks;  ///< Cracks, or a field with a colour bar.
  std::vector<PatternPanel> panels;
};

/// The picture; its size follows from the specimens. At least one panel.
Drawing draw_pattern_grid(const PatternGrid& grid);

/// How many pixels a millimetre has in every panel.
double pattern_grid_scale(const PatternGrid& grid);

}  // namespace asperity::render
