#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/calibration/linear_fit.hpp"

namespace asperity {

/// One source of variation. The residual, pure error and total have no test.
struct AnovaLine {
  std::string source;
  int df = 0;
  double sum_of_squares = 0;
  std::optional<double> mean_square, f, p;
};

/// Scatter of runs with equal factor levels about their mean: what the mesh does by itself.
struct PureError {
  int df = 0;
  double sum_of_squares = 0;
};

/// What of the residual exceeds the pure error: what a quadratic cannot follow.
struct LackOfFit {
  int df = 0;
  double sum_of_squares = 0, f = 0, p = 0;
};

/// The analysis of variance of a full quadratic. `lines` in order: "model"; "linear", "interactions", "quadratic" (each
/// what it explains beyond those before it, so that they add up to the model); every term (what it explains beyond all
/// others, which does not add up unless the design is orthogonal); "residual", "lack_of_fit", "pure_error" (the last
/// two add up to the residual; left out where no levels were run twice); "total".
struct Anova {
  std::vector<AnovaLine> lines;
  std::optional<LackOfFit> lack_of_fit;  ///< None without pure error, or where the fit uses up all distinct levels.
  std::optional<PureError> pure_error;   ///< None where no levels were run twice.
};

/// Eqs. (S10)-(S12). `full` is a fit to `observed`.
Anova analyse_variance(const Observations& observed, const LinearFit& full);

/// Pure error over groups of equal levels, whatever the model, Eq. (S11).
std::optional<PureError> pure_error(const Observations& observed);

}  // namespace asperity
