#pragma once
#include <string>
#include <vector>

#include "render/drawing.hpp"

namespace asperity::render {

/// A row of every panel; rows of one group follow one another.
struct BarRow {
  std::string group, name;
};

/// One bar a row; NaN: none.
struct BarPanel {
  std::string heading;
  std::vector<double> values;
  Colour colour;
};

/// Horizontal bars from zero in panels side by side, with one scale for all and the rows' names once at the left.
struct BarPanels {
  std::string title, caption, x_label;
  std::vector<BarRow> rows;
  std::vector<BarPanel> panels;
  double guide = 2;  ///< Dashed lines at plus and minus this.
};

/// The picture grows with the rows; at least one row and one panel, at most five panels.
Drawing draw_bar_panels(const BarPanels& plot);

}  // namespace asperity::render
