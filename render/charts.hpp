#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "render/colour_map.hpp"
#include "render/contours.hpp"
#include "render/drawing.hpp"
#include "render/markers.hpp"
#include "render/range.hpp"

/// Charts as layers, and figures of one chart or of many. Texts are UTF-8 with "_{...}" for lowered parts, units in
/// square brackets. A layer's label goes into the figure's legend, once for all charts; an empty one stays out.
namespace asperity::render {

/// A line; a value that is not finite breaks it. `casing` is the width of the white edge under it, in pixels. At the
/// points with the numbers `arrows`, heads show which way it goes.
struct LineLayer {
  std::string label;
  std::vector<double> x, y;
  Stroke stroke;
  double casing = 0;
  std::vector<std::size_t> arrows = {};
};

/// The area between two curves over the same ascending x.
struct BandLayer {
  std::string label;
  std::vector<double> x, lower, upper;
  Colour fill;
};

/// Points with half-widths of error bars (empty: none) and names beside them (empty: none).
struct PointLayer {
  std::string label;
  std::vector<double> x, y;
  Marker marker;
  std::vector<double> x_error, y_error;
  std::vector<std::string> names;
};

/// A rectangle, filled, outlined or both.
struct BoxLayer {
  std::string label;
  Range x, y;
  std::optional<Colour> fill;
  std::optional<Stroke> edge;
};

/// A quantity over the chart's two variables as filled bands between `levels` with labelled lines on them.
struct FieldLayer {
  ScalarGrid grid;
  std::vector<double> levels;  ///< Ascending; see round_levels.
  std::string value_label;     ///< Beside the colour bar: quantity and unit.
  ColourMap map = ColourMap::cividis;
  std::vector<std::string> level_names = {};  ///< Instead of numbers, one a level; empty: numbers.
};

/// What stands at a field's level.
std::string level_name(const FieldLayer& field, std::size_t level);

/// One emphasised line of equal value, with its name on it.
struct ContourLayer {
  std::string label;
  ScalarGrid grid;
  double level = 0;
  Stroke stroke;
  std::string name;
};

using Layer = std::variant<LineLayer, BandLayer, PointLayer, BoxLayer, FieldLayer, ContourLayer>;

/// One pair of axes with its layers, drawn in order. Ranges not given enclose the layers with some headroom; categories
/// stand at x = 1, 2, ... instead of numbers. Along a logarithmic axis, layers and range are decadic logarithms, and the
/// ticks carry the numbers.
struct Chart {
  std::string heading, x_label, y_label;
  std::vector<Layer> layers;
  std::optional<Range> x_range, y_range;
  std::vector<std::string> x_categories;
  bool x_log = false, y_log = false;
};

/// `shared`: one colour bar for the whole figure, by the first chart's field; all charts then need the same levels.
enum class ColourBars { each, shared };

/// Whether charts have letters (a), (b), ... before their headings.
enum class Letters { none, each };

/// Charts in rows of `columns`, with one title, one caption under it and one legend.
struct ChartFigure {
  std::string title, caption;
  std::vector<Chart> charts;
  int columns = 1;
  ColourBars colour_bars = ColourBars::each;
  Letters letters = Letters::none;
  int width = 1600, height = 1200;
};

/// About `parts` + 1 round levels inside the finite values' range, and the range's ends where it is empty.
std::vector<double> round_levels(const std::vector<double>& values, int parts);

/// The figure as a drawing.
Drawing draw_figure(const ChartFigure& figure);

}  // namespace asperity::render
