#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/drawing.hpp"
#include "render/range.hpp"

namespace asperity::render {

/// Stacked areas lie one on another in the order of the series, over the same x values.
enum class SeriesKind { line, points, line_and_points, stacked_area };
enum class VerticalAxis { left, right };

/// How a series is drawn. `look` is its colour and dash pattern in style::kLines and kDashes, counted round; without
/// it, the series' place in the plot is taken.
struct SeriesStyle {
  SeriesKind kind = SeriesKind::line;
  VerticalAxis axis = VerticalAxis::left;
  std::optional<int> look;
};

/// One line of a plot. A value that is not finite breaks the line. An empty label stays out of the legend.
struct PlotSeries {
  std::string label;
  std::vector<double> x, y;
  SeriesStyle style;
};

/// A plot; texts are UTF-8 ("σ₁ [MPa]", "ε [%]"), units in square brackets. Ranges not given enclose the data and, for
/// y, zero where the data come near it. The second y axis appears if a series uses it.
struct Plot {
  std::string title, x_label, y_label, second_y_label;
  std::vector<PlotSeries> series;
  std::optional<Range> x_range, y_range, second_y_range;
  int width = 1600, height = 1200;
};

/// The plot as a drawing.
Drawing draw_plot(const Plot& plot);

/// Writes `path`.png and `path`.svg. Errors: Error(output) with path and reason.
void write_plot(const Plot& plot, const std::filesystem::path& path_without_extension);

}  // namespace asperity::render
