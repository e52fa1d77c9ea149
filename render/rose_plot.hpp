#pragma once
#include <string>
#include <vector>

#include "render/drawing.hpp"

namespace asperity::render {

/// Length by direction: sectors of equal width from 0 to 180 degrees, counted from the x axis.
struct Rose {
  std::string heading;
  std::vector<double> sectors;
  Colour fill;
};

/// Roses side by side at one scale, each sector with its share of its rose as area, drawn at both ends of a direction.
struct RosePlot {
  std::string title, caption;
  std::vector<Rose> roses;
  double axis_deg = 90;    ///< A direction that is marked, such as the load's.
  std::string axis_label;  ///< What it is.
  int width = 1600, height = 1000;
};

/// The plot as a drawing. A rose without length is an empty circle.
Drawing draw_roses(const RosePlot& plot);

}  // namespace asperity::render
