#pragma once
#include "render/surface_plots.hpp"

namespace asperity::render {

/// One response: what its model says of each run and what the run gave. Rows are counted from 1.
struct FittedResponse {
  std::string heading, label;             ///< Name; quantity and unit.
  std::vector<double> simulated, fitted;  ///< In the response's unit, one a run.
  std::vector<double> studentised;        ///< Internally studentised residuals, one a run.
  std::vector<int> rows;                  ///< The runs' rows in the design.
  std::vector<DesignPoint> points;        ///< The runs' kinds; `at` is not used.
  double residual_sd = 0;                 ///< In the response's unit.
};

/// Predicted over simulated with the 1:1 line and two residual standard deviations at both sides; centre points are
/// marked apart, since their scatter along x is that of the mesh alone.
Chart predicted_against_simulated(const FittedResponse& response);

/// Ordered studentised residuals over normal scores (Blom 1958): on the line if they are normally distributed.
Chart normal_probability(const FittedResponse& response);

/// Studentised residuals over fitted values; those beyond 2 carry their row.
Chart residual_against_fitted(const FittedResponse& response);

/// Studentised residuals over the order of the runs.
Chart residual_against_row(const FittedResponse& response);

}  // namespace asperity::render
