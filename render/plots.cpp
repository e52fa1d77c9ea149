#include "render/plots.hpp"

#include <algorithm>
#include <cmath>

#include "render/axes.hpp"
#include "render/paint.hpp"
#include "render/plot_legend.hpp"
#include "render/style.hpp"
#include "render/text_metrics.hpp"
#include "render/title_caption.hpp"

namespace asperity::render {
namespace {

constexpr int kParts = 7;

/// The upper edge of every series: its own y, or for stacked areas the sum with those below.
std::vector<std::vector<double>> upper_edges(const Plot& plot) {
  std::vector<std::vector<double>> edges;
  const std::vector<double>* below = nullptr;
  edges.reserve(plot.series.size());
  for (const PlotSeries& series : plot.series) {
    edges.push_back(series.y);
    if (series.style.kind != SeriesKind::stacked_area) continue;
    for (std::size_t i = 0; below && i < std::min(below->size(), series.y.size()); ++i) edges.back()[i] += (*below)[i];
    below = &edges.back();
  }
  return edges;
}

Range range_of_x(const Plot& plot) {
  std::vector<double> values;
  for (const PlotSeries& series : plot.series) values.insert(values.end(), series.x.begin(), series.x.end());
  return plot.x_range.value_or(with_headroom(reaching_zero(range_of(values))));
}

Range range_of_y(const Plot& plot, VerticalAxis axis) {
  const auto edges = upper_edges(plot);
  std::vector<double> values;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    if (plot.series[i].style.axis != axis) continue;
    values.insert(values.end(), edges[i].begin(), edges[i].end());
    if (plot.series[i].style.kind == SeriesKind::stacked_area) values.push_back(0);
  }
  const auto& given = axis == VerticalAxis::left ? plot.y_range : plot.second_y_range;
  return given.value_or(with_headroom(reaching_zero(range_of(values))));
}

bool uses_second_axis(const Plot& plot) {
  return std::any_of(plot.series.begin(), plot.series.end(),
                     [](const PlotSeries& series) { return series.style.axis == VerticalAxis::right; });
}

Vec2 place(const PlotArea& area, const PlotSeries& series, double x, double y) {
  const Vec2 at = series.style.axis == VerticalAxis::left ? area.place(x, y) : area.place_second(x, y);
  const auto far = [](double low, double value, double high) { return std::clamp(value, low - 1e4, high + 1e4); };
  return {far(area.box.left, at.x, area.box.right), far(area.box.top, at.y, area.box.bottom)};
}

/// The runs of finite points of a series, in pixels.
std::vector<std::vector<Vec2>> runs(const PlotArea& area, const PlotSeries& series) {
  std::vector<std::vector<Vec2>> parts(1);
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    if (std::isfinite(series.x[i]) && std::isfinite(series.y[i]))
      parts.back().push_back(place(area, series, series.x[i], series.y[i]));
    else if (!parts.back().empty())
      parts.emplace_back();
  }
  return parts;
}

void draw_line(Drawing& drawing, const PlotArea& area, const PlotSeries& series, const SeriesLook& look) {
  for (const auto& run : runs(area, series)) {
    const bool lines = series.style.kind != SeriesKind::points && run.size() > 1;
    if (lines) drawing.shapes.push_back(Polyline{run, look.stroke});
    if (series.style.kind == SeriesKind::line) continue;
    for (const Vec2 point : run) add_disc(drawing, point, style::kMarkerRadius, look.stroke.colour);
  }
}

void draw_areas(Drawing& drawing, const PlotArea& area, const Plot& plot) {
  const auto edges = upper_edges(plot);
  const std::vector<double>* below = nullptr;
  for (std::size_t s = 0; s < plot.series.size(); ++s) {
    const PlotSeries& series = plot.series[s];
    if (series.style.kind != SeriesKind::stacked_area) continue;
    Band band{{}, {}, look_of(plot, s).fill};
    for (std::size_t i = 0; i < std::min(series.x.size(), edges[s].size()); ++i) {
      band.lower.push_back(place(area, series, series.x[i], below && i < below->size() ? (*below)[i] : 0));
      band.upper.push_back(place(area, series, series.x[i], edges[s][i]));
    }
    drawing.shapes.push_back(band);
    drawing.shapes.push_back(Polyline{band.upper, {look_of(plot, s).stroke.colour, 2, {}, Cap::butt}});
    below = &edges[s];
  }
}

/// Hides what a given range leaves outside: white over the margins, then the axes are drawn on top.
void cover_margins(Drawing& drawing, const Box& inside) {
  const double width = drawing.width, height = drawing.height;
  add_box(drawing, {0, 0, width, inside.top}, style::kPaper);
  add_box(drawing, {0, inside.bottom, width, height}, style::kPaper);
  add_box(drawing, {0, 0, inside.left, height}, style::kPaper);
  add_box(drawing, {inside.right, 0, width, height}, style::kPaper);
}

}  // namespace

Drawing draw_plot(const Plot& plot) {
  Drawing drawing{plot.width, plot.height, {}}, head = drawing;
  const double below_title = draw_title(head, plot.title);
  const double top = draw_plot_legend(head, plot, {kFigureMargin, below_title, plot.width - kFigureMargin, 0});
  const AxesStyle axes{style::kTickSize, style::kLabelSize, 2};
  Axis second;
  if (uses_second_axis(plot)) second = make_axis(range_of_y(plot, VerticalAxis::right), plot.second_y_label, kParts);
  const PlotArea area = fit_axes({kFigureMargin, top, plot.width - kFigureMargin, plot.height - kFigureMargin},
                                 make_axis(range_of_x(plot), plot.x_label, kParts + 1),
                                 make_axis(range_of_y(plot, VerticalAxis::left), plot.y_label, kParts), second, axes);
  draw_grid(drawing, area, axes);
  draw_areas(drawing, area, plot);
  for (std::size_t s = 0; s < plot.series.size(); ++s)
    if (plot.series[s].style.kind != SeriesKind::stacked_area)
      draw_line(drawing, area, plot.series[s], look_of(plot, s));
  cover_margins(drawing, area.box);
  draw_axes(drawing, area, axes);
  drawing.shapes.insert(drawing.shapes.end(), head.shapes.begin(), head.shapes.end());
  return drawing;
}

void write_plot(const Plot& plot, const std::filesystem::path& path_without_extension) {
  const Drawing drawing = draw_plot(plot);
  std::filesystem::path png = path_without_extension, svg = path_without_extension;
  png += ".png";
  svg += ".svg";
  write_png(drawing, png);
  write_svg(drawing, svg);
}

}  // namespace asperity::render
