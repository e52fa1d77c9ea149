#include "render/charts.hpp"

#include <algorithm>
#include <cmath>

#include "render/axes.hpp"
#include "render/chart_layers.hpp"
#include "render/chart_legend.hpp"
#include "render/colour_bar.hpp"
#include "render/style.hpp"
#include "render/text_metrics.hpp"
#include "render/title_caption.hpp"

namespace asperity::render {
namespace {

constexpr double kBetween = 26, kHeadingGap = 12;   // pixels
constexpr double kTickGap = 14;                     // between the labels of an axis, pixels
constexpr double kTickRoom = 95, kTickRoomUp = 75;  // pixels of an axis that one tick may take

/// Where a chart stands in the figure, what it needs around its frame, and its axes.
struct Cell {
  std::size_t row = 0, column = 0;
  Axis x, y;
  Margins around;
};

AxesStyle style_for(const ChartFigure& figure) {
  if (figure.columns < 2) return {style::kTickSize, style::kLabelSize, 2};
  return figure.columns < 3 ? AxesStyle{24, 26, 2} : AxesStyle{22, 24, 2};
}

void append(std::vector<double>& values, const std::vector<double>& more) {
  values.insert(values.end(), more.begin(), more.end());
}

void append_around(std::vector<double>& values, const std::vector<double>& centres, const std::vector<double>& widths) {
  for (std::size_t i = 0; i < std::min(centres.size(), widths.size()); ++i)
    append(values, {centres[i] - widths[i], centres[i] + widths[i]});
}

/// Everything a layer shows along x and along y.
struct Extents {
  std::vector<double> x, y;
  void operator()(const LineLayer& l) { add(l.x, l.y); }
  void operator()(const BandLayer& l) {
    add(l.x, l.lower);
    append(y, l.upper);
  }
  void operator()(const PointLayer& l) {
    add(l.x, l.y);
    append_around(x, l.x, l.x_error);
    append_around(y, l.y, l.y_error);
  }
  void operator()(const BoxLayer& l) { add({l.x.low, l.x.high}, {l.y.low, l.y.high}); }
  void operator()(const FieldLayer& l) { add(l.grid.x, l.grid.y); }
  void operator()(const ContourLayer&) {}
  void add(const std::vector<double>& along, const std::vector<double>& up) {
    append(x, along);
    append(y, up);
  }
};

const FieldLayer* field_of(const Chart& chart) {
  for (const Layer& layer : chart.layers)
    if (const auto* field = std::get_if<FieldLayer>(&layer)) return field;
  return nullptr;
}

Range natural_range(const Chart& chart, const std::vector<double>& values) {
  return field_of(chart) ? range_of(values) : with_headroom(reaching_zero(range_of(values)));
}

Axis category_axis(const Chart& chart) {
  const double count = static_cast<double>(chart.x_categories.size());
  Axis axis{chart.x_range.value_or(Range{0.4, count + 0.6}), {}, chart.x_label};
  for (std::size_t i = 0; i < chart.x_categories.size(); ++i)
    axis.ticks.push_back({static_cast<double>(i + 1), chart.x_categories[i]});
  return axis;
}

int parts_for(double length, double room) { return std::clamp(static_cast<int>(length / room), 3, 9); }

/// An axis of about `parts` ticks, or of fewer where their labels would not stand apart on so many pixels.
Axis spaced_axis(const Range& range, const std::string& label, int parts, double length, double tick_size) {
  for (;; --parts) {
    Axis axis = make_axis(range, label, parts);
    double needed = 0;
    for (const Tick& tick : axis.ticks) needed += text_width(tick.label, tick_size) + kTickGap;
    if (needed <= length || parts <= 2) return axis;
  }
}

Cell cell_of(const ChartFigure& figure, std::size_t number, const AxesStyle& style) {
  const Chart& chart = figure.charts[number];
  const std::size_t columns = static_cast<std::size_t>(figure.columns);
  const std::size_t rows = (figure.charts.size() + columns - 1) / columns;
  Extents extents;
  for (const Layer& layer : chart.layers) std::visit(extents, layer);
  Cell cell{number / columns, number % columns, {}, {}, {}};
  const double length = 0.75 * figure.width / figure.columns;
  const int across = parts_for(length, kTickRoom);
  const int up = parts_for(0.7 * figure.height / static_cast<double>(rows), kTickRoomUp);
  const Range x = chart.x_range.value_or(natural_range(chart, extents.x));
  if (chart.x_log)
    cell.x = make_log_axis(x, chart.x_label);
  else if (!chart.x_categories.empty())
    cell.x = category_axis(chart);
  else
    cell.x = spaced_axis(x, chart.x_label, across, length, style.tick_size);
  const Range y = chart.y_range.value_or(natural_range(chart, extents.y));
  cell.y = chart.y_log ? make_log_axis(y, chart.y_label) : make_axis(y, chart.y_label, up);
  cell.around = axes_margins(cell.x, cell.y, {}, style);
  if (!chart.heading.empty() || figure.letters == Letters::each)
    cell.around.top = 1.25 * style.label_size + kHeadingGap;
  if (!chart.x_categories.empty()) cell.around.right = 0;  // their texts stand within the axis
  const FieldLayer* field = field_of(chart);
  if (field && figure.colour_bars == ColourBars::each)
    cell.around.right = std::max(cell.around.right, colour_bar_room(*field, style));
  return cell;
}

/// Frames of one size whose surroundings are, along each column and row, the largest that any chart there needs.
std::vector<Box> frames_of(const std::vector<Cell>& cells, const Box& room) {
  std::size_t columns = 0, rows = 0;
  for (const Cell& cell : cells) columns = std::max(columns, cell.column + 1), rows = std::max(rows, cell.row + 1);
  std::vector<double> left(columns), right(columns), top(rows), bottom(rows);
  for (const Cell& cell : cells) {
    left[cell.column] = std::max(left[cell.column], cell.around.left);
    right[cell.column] = std::max(right[cell.column], cell.around.right);
    top[cell.row] = std::max(top[cell.row], cell.around.top);
    bottom[cell.row] = std::max(bottom[cell.row], cell.around.bottom);
  }
  const auto sum = [](const std::vector<double>& values) {
    double total = kBetween * static_cast<double>(values.size() - 1);
    for (const double value : values) total += value;
    return total;
  };
  const double across = room.width() - sum(left) - (sum(right) - kBetween * static_cast<double>(columns - 1));
  const double up = room.height() - sum(top) - (sum(bottom) - kBetween * static_cast<double>(rows - 1));
  const double width = across / static_cast<double>(columns), height = up / static_cast<double>(rows);
  std::vector<Box> frames;
  for (const Cell& cell : cells) {
    double x = room.left + left[cell.column], y = room.top + top[cell.row];
    for (std::size_t c = 0; c < cell.column; ++c) x += left[c] + width + right[c] + kBetween;
    for (std::size_t r = 0; r < cell.row; ++r) y += top[r] + height + bottom[r] + kBetween;
    frames.push_back({std::round(x), std::round(y), std::round(x + width), std::round(y + height)});
  }
  return frames;
}

std::string heading_of(const ChartFigure& figure, std::size_t number) {
  const std::string letter = {'(', static_cast<char>('a' + number % 26), ')'};
  const std::string& heading = figure.charts[number].heading;
  if (figure.letters == Letters::none) return heading;
  return heading.empty() ? letter : letter + " " + heading;
}

void draw_heading(Drawing& drawing, const std::string& heading, const Box& frame, double right,
                  const AxesStyle& style) {
  const double size = fitting_size(heading, style.label_size, Weight::bold, right - frame.left);
  drawing.shapes.push_back(Text{{frame.left, frame.top - kHeadingGap},
                                heading,
                                size,
                                Anchor::left,
                                Weight::bold,
                                Direction::across,
                                style::kInk});
}

/// Points and their names lie over everything, the frame too: star points stand on it.
void draw_chart(Drawing& drawing, const Chart& chart, const PlotArea& area, const AxesStyle& style) {
  Occupied occupied;
  for (const Layer& layer : chart.layers) reserve(area, layer, occupied);
  if (!field_of(chart)) draw_grid(drawing, area, style);
  for (const Layer& layer : chart.layers)
    if (!std::holds_alternative<PointLayer>(layer)) draw_layer(drawing, area, layer, occupied);
  for (const Layer& layer : chart.layers)
    if (const auto* contour = std::get_if<ContourLayer>(&layer)) draw_contour_name(drawing, area, *contour, occupied);
  draw_axes(drawing, area, style);
  for (const Layer& layer : chart.layers)
    if (std::holds_alternative<PointLayer>(layer)) draw_layer(drawing, area, layer, occupied);
  for (const Layer& layer : chart.layers)
    if (const auto* points = std::get_if<PointLayer>(&layer)) draw_names(drawing, area, *points, occupied);
}

void draw_charts(Drawing& drawing, const ChartFigure& figure, Box room) {
  const AxesStyle style = style_for(figure);
  const FieldLayer* shared = figure.colour_bars == ColourBars::shared ? field_of(figure.charts.front()) : nullptr;
  if (shared) room.right -= colour_bar_room(*shared, style);
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < figure.charts.size(); ++i) cells.push_back(cell_of(figure, i, style));
  const std::vector<Box> frames = frames_of(cells, room);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const PlotArea area{frames[i], cells[i].x, cells[i].y, {}};
    draw_chart(drawing, figure.charts[i], area, style);
    const std::string heading = heading_of(figure, i);
    if (!heading.empty()) draw_heading(drawing, heading, frames[i], frames[i].right + cells[i].around.right, style);
    const FieldLayer* field = field_of(figure.charts[i]);
    if (field && !shared) draw_colour_bar(drawing, frames[i], *field, style);
  }
  if (shared) draw_colour_bar(drawing, {0, frames.front().top, room.right, frames.back().bottom}, *shared, style);
}

}  // namespace

Drawing draw_figure(const ChartFigure& figure) {
  Drawing drawing{figure.width, figure.height, {}};
  const double below_title = draw_title(drawing, figure.title);
  const double right = figure.width - kFigureMargin;
  const double top = draw_chart_legend(drawing, figure.charts, {kFigureMargin, below_title, right, 0});
  const double bottom = draw_caption(drawing, figure.caption);
  if (!figure.charts.empty()) draw_charts(drawing, figure, {kFigureMargin, top, right, bottom});
  return drawing;
}

}  // namespace asperity::render
