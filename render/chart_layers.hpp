#pragma once
#include "render/axes.hpp"
#include "render/charts.hpp"

namespace asperity::render {

/// Where a chart's texts and markers are, so that other texts keep clear of them; the emphasised lines, of which the
/// texts on other lines keep clear; and all lines, of which points' names keep clear where they can; pixels.
struct Occupied {
  /// A piece of a layer's line.
  struct Piece {
    Box box;
    const void* layer;
  };
  std::vector<Box> boxes;
  std::vector<Piece> lines;
  std::vector<std::vector<Vec2>> curves;
  bool free(const Box& box) const;
  bool free_of_curves(const Box& box) const;
  bool free_of_lines_but(const void* layer, const Box& box) const;
};

/// Notes where a layer's markers and emphasised lines will be.
void reserve(const PlotArea& area, const Layer& layer, Occupied& occupied);

/// The finite runs of a line, in pixels.
std::vector<std::vector<Vec2>> finite_runs(const PlotArea& area, const std::vector<double>& x,
                                           const std::vector<double>& y);

/// Draws one layer inside the area; what lies beyond the frame is cut off.
void draw_layer(Drawing& drawing, const PlotArea& area, const Layer& layer, Occupied& occupied);

/// Draws the names of a layer's points, each at the first place around its point that is free, of lines too
/// if there is such a place.
void draw_names(Drawing& drawing, const PlotArea& area, const PointLayer& layer, Occupied& occupied);

/// The colours between the levels of a field: one more than there are levels.
std::vector<Colour> band_colours(const FieldLayer& field);

/// Draws a field's bands and lines. README.md says why filled bands.
void draw_field(Drawing& drawing, const PlotArea& area, const FieldLayer& field, Occupied& occupied);

/// Draws an emphasised line of equal value.
void draw_contour(Drawing& drawing, const PlotArea& area, const ContourLayer& contour);

/// Draws such a line's name on it, off other lines where there is such a place.
void draw_contour_name(Drawing& drawing, const PlotArea& area, const ContourLayer& contour, Occupied& occupied);

/// From a point to the ends of its error bars, in pixels: along x, along y, where it has them.
std::vector<Vec2> error_arms(const PlotArea& area, const PointLayer& layer, std::size_t i);

/// Whether a point is inside the box or within half a pixel of it: a point on the frame counts.
bool near_box(Vec2 p, const Box& box);

bool within(const Box& inner, const Box& outer);

/// The parts of a line that lie in the box, cut at its edges.
std::vector<std::vector<Vec2>> clipped(const std::vector<Vec2>& line, const Box& box);

}  // namespace asperity::render
