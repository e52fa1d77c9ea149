#pragma once
#include "render/charts.hpp"

namespace asperity::render {

/// What n fresh meshes gave of one property, over its target.
struct VerifiedProperty {
  std::string name;  ///< Lines with "\n" between them; each at most a sixth of the figure wide.
  double target = 0, mean = 0, sd = 0,
         tolerance = 0;  ///< In the property's unit; the tolerance as a part of the target.
  std::optional<double> predicted;
  std::vector<double> values;  ///< One a mesh.
};

/// Means ± standard deviations of all properties as deviations from the target in %, each with its tolerance band, the
/// model's prediction and the single meshes.
ChartFigure verification_bars(const std::string& title, const std::vector<VerifiedProperty>& properties);

/// A set of microparameters by two properties: means, standard deviations and the single meshes.
struct VerifiedSet {
  std::string name;
  double x = 0, y = 0, x_sd = 0, y_sd = 0;
  std::vector<double> x_values, y_values;
};

struct TradeOff {
  std::string title, caption, x_label, y_label;
  Range x_target, y_target;  ///< The targets with their tolerances.
  std::vector<VerifiedSet> sets;
};

/// Verified sets over two properties with the box in which both targets are met.
ChartFigure trade_off(const TradeOff& given);

}  // namespace asperity::render
