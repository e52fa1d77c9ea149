#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/report/document.hpp"
#include "app/report/quantities.hpp"
#include "app/report/response_surface.hpp"
#include "render/surface_plots.hpp"

namespace asperity::app {

/// One factor of the design: real = centre + step coded, or centre step^coded on a logarithmic scale.
struct FactorData {
  std::string name, pointer;
  Quantity quantity;
  double centre = 0, step = 1;
  bool logarithmic = false;
  double real(double coded) const;
  double coded(double real) const;
};

/// One response's model, and the runs behind it: rows of the design from 0.
struct ModelData {
  std::string property;
  ResponseSurface surface;
  std::vector<std::size_t> rows;
  std::vector<double> simulated, fitted, studentised;  ///< One a row of `rows`.
  double residual_sd = 0;
};

struct TargetData {
  double value = 0, weight = 1;
};

/// What the figures of a calibration's report need, from calibration.json; empty where it is not there.
struct CalibrationData {
  std::vector<FactorData> factors;
  std::vector<std::vector<double>> coded;
  std::vector<render::DesignPointKind> kinds;
  double reach = 1;   ///< Largest distance of a run from the design's centre along one axis, coded.
  double radius = 1;  ///< Largest distance of a run from the design's centre, coded.
  std::map<std::string, TargetData> targets;
  DesirabilityShape desirability;
  std::vector<ModelData> models;
  std::vector<double> solution;                      ///< Coded; empty: none.
  std::vector<std::optional<render::Range>> region;  ///< 95 % region of each factor, real; empty: none.

  /// The solution, or the design's centre.
  std::vector<double> held() const;
  /// Weighted geometric mean of the targets' desirabilities by the models; NaN without targets.
  double overall_desirability(const std::vector<double>& coded) const;
  /// Weighted product of the desirabilities, the overall one to the power of total_weight(); where any is 0, negative
  /// by how far the worst target is beyond its half range. It goes through the edge without the overall one's jump,
  /// which no grid resolves, so lines of equal desirability are drawn from it.
  double desirability_product(const std::vector<double>& coded) const;
  double total_weight() const;
};

CalibrationData read_calibration_data(const Value& root);

/// The quantity of a pointer: a factor's own label, symbol and unit where it is one.
Quantity parameter_quantity(const CalibrationData& data, const std::string& pointer);

}  // namespace asperity::app
