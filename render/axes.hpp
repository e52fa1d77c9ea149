#pragma once
#include <string>
#include <vector>

#include "render/drawing.hpp"
#include "render/range.hpp"

namespace asperity::render {

/// A mark on an axis; "\n" in the label of a horizontal axis begins a second line.
struct Tick {
  double value = 0;
  std::string label;
};

/// A scale with round ticks. `label` names quantity and unit, with a power of ten where the numbers are awkward.
struct Axis {
  Range range;
  std::vector<Tick> ticks;
  std::string label;
};

/// A scale over exactly `range`, or a little around an empty one, with about `parts` round ticks.
Axis make_axis(Range range, const std::string& label, int parts);

/// A logarithmic scale over a range of decadic logarithms; ticks at powers of ten and, over less than three decades, at
/// twice and five times them.
Axis make_log_axis(Range exponents, const std::string& label);

/// A number with a true minus sign and the decimals that tell steps of `step` apart.
std::string tick_label(double value, double step);

/// Ten to an integer power with superscript digits: "10⁻³".
std::string power_of_ten(int exponent);

/// Two axes and where they are drawn; `second_y`, with its ticks on the right, if it has any.
struct PlotArea {
  Box box;
  Axis x, y, second_y;
  Vec2 place(double x_value, double y_value) const;
  Vec2 place_second(double x_value, double y_value) const;
};

/// Sizes of an area's texts and lines, in pixels.
struct AxesStyle {
  double tick_size = 26, label_size = 28, line_width = 2;
};

/// Room around a frame, in pixels.
struct Margins {
  double left = 0, top = 0, right = 0, bottom = 0;
};

/// The room that ticks and labels take around the frame.
Margins axes_margins(const Axis& x, const Axis& y, const Axis& second_y, const AxesStyle& style);

/// The area whose axes, tick labels and axis labels together fill `outer`.
PlotArea fit_axes(const Box& outer, Axis x, Axis y, Axis second_y, const AxesStyle& style);

/// The pale lines at the ticks of x and of the left y, which go under the data.
void draw_grid(Drawing& drawing, const PlotArea& area, const AxesStyle& style);

/// Frame, ticks and labels, which go over the data.
void draw_axes(Drawing& drawing, const PlotArea& area, const AxesStyle& style);

}  // namespace asperity::render
