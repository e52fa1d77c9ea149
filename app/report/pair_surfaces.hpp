#pragma once
#include <functional>
#include <vector>

#include "app/report/calibration_data.hpp"
#include "render/surface_plots.hpp"

namespace asperity::app {

/// Two factors by their numbers from 0, i < j.
struct Pair {
  std::size_t i = 0, j = 1;
};

std::vector<Pair> pairs_of(const CalibrationData& data);

/// A quantity of the coded levels.
using LevelFunction = std::function<double(const std::vector<double>&)>;

/// The quantity over two factors in real units as far as the design's star points reach, the other factors held at the
/// solution or, without one, at the design's centre.
render::ScalarGrid over_pair(const CalibrationData& data, Pair pair, const LevelFunction& value);

/// Axes, design points, solution with its region, and the limit of the design, of a surface over two factors.
render::SurfacePlot plot_of_pair(const CalibrationData& data, Pair pair);

/// The quantity over all pairs of factors with the same levels; `common` gives label, colours, targets (whose grids are
/// the quantity's own) and levels.
render::ChartFigure pair_figure(const CalibrationData& data, const LevelFunction& value,
                                const render::SurfacePlot& common);

/// "Other factors at the solution.", or what else holds; empty for two factors.
std::string where_held(const CalibrationData& data);

}  // namespace asperity::app
