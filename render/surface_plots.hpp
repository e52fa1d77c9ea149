#pragma once
#include "render/charts.hpp"

namespace asperity::render {

/// A point of a design: a corner of the cube, a star point on an axis, or the centre.
enum class DesignPointKind { factorial, star, centre };

/// A point of a design seen along all factors but the two that are drawn.
struct DesignPoint {
  Vec2 at;
  DesignPointKind kind = DesignPointKind::factorial;
};

/// A rectangle of two factors, their confidence intervals.
struct FactorBox {
  Range x, y;
};

/// A line of equal value that is to be emphasised.
struct TargetLine {
  ScalarGrid grid;
  double value = 0;
  std::string name;
};

/// A quantity over two factors and what is marked on it.
struct SurfacePlot {
  std::string heading, x_label, y_label, value_label;
  ScalarGrid grid;
  std::vector<double> levels;            ///< Empty: about ten round ones.
  std::vector<std::string> level_names;  ///< As in FieldLayer.
  std::vector<TargetLine> targets;
  std::vector<DesignPoint> points;
  std::optional<Vec2> solution;
  std::optional<FactorBox> region;  ///< 95 % region of the solution.
  std::vector<Vec2> limit;          ///< Closed line around the part that the runs support; empty: none.
  ColourMap map = ColourMap::cividis;
};

/// The surface as filled bands with labelled lines; target lines, 95 % region, design points and solution over it.
Chart surface_chart(const SurfacePlot& plot);

}  // namespace asperity::render
