#pragma once
#include "render/charts.hpp"

namespace asperity::render {

/// A response along one factor, the others held; `lower` and `upper` are its 95 % confidence band, or empty.
struct EffectCurve {
  std::vector<double> x, mean, lower, upper;
};

/// One response along every factor, in the order of MainEffects::factor_labels.
struct EffectRow {
  std::string label;  ///< Quantity and unit.
  std::vector<EffectCurve> curves;
  std::optional<double> target;
};

struct MainEffects {
  std::string title, caption;
  std::vector<std::string> factor_labels;  ///< Factor and unit.
  std::vector<EffectRow> rows;
};

/// One row of charts a response and one chart a factor; a row shares its y axis, a column its x axis.
ChartFigure main_effects(const MainEffects& effects);

/// One response along a factor at the low, middle and high level of another one.
struct InteractionPair {
  std::string heading, x_label;
  std::array<EffectCurve, 3> curves;
};

struct InteractionRow {
  std::string label;  ///< Quantity and unit.
  std::vector<InteractionPair> pairs;
};

struct Interactions {
  std::string title, caption;
  std::array<std::string, 3> level_names;  ///< Low, middle and high level of the second factor.
  std::vector<InteractionRow> rows;
};

/// One row of charts a response and one chart a pair of factors: lines that are not parallel show an interaction.
ChartFigure interactions(const Interactions& given);

}  // namespace asperity::render
