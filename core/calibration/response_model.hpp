#pragma once
#include <string>
#include <utility>
#include <vector>

#include "core/calibration/anova.hpp"
#include "core/calibration/design.hpp"
#include "core/calibration/elimination.hpp"
#include "core/calibration/residual_checks.hpp"

/// A measured property as a function of the coded factors.
namespace asperity {

/// What the quadratic is fitted to: the response, or its logarithm where its scatter grows with it.
enum class Transform { none, logarithm };

/// One measured property over a design; NaN where the run is bad.
struct Response {
  std::string name;
  std::vector<double> values;  ///< One a row of the design.
  Transform transform = Transform::none;
};

/// A run that gave no value, and what the analysis does about it.
struct BadRun {
  std::size_t row = 0;
  std::string test, reason, treatment;
};

struct Responses {
  std::vector<Response> list;
  std::vector<BadRun> bad_runs;
};

struct ModelOptions {
  double elimination_level = 0.05;
  Hierarchy hierarchy = Hierarchy::hierarchical;
};

/// Full and reduced quadratic of one response, with their tests. Everything but predictions is on the fitted scale.
struct ResponseModel {
  std::string name;
  Transform transform = Transform::none;
  LinearFit full;
  LinearFit reduced;
  std::vector<std::string> eliminated;  ///< First to last.
  Anova anova;                          ///< Of the full quadratic.
  ResidualChecks residual_checks;       ///< Of the full quadratic.
};

/// What the reduced model says of one point, on the response's own scale.
struct Prediction {
  double value = 0;             ///< Mean over meshes; with the logarithm their median.
  double sd_mean = 0;           ///< Standard deviation of that mean, from the coefficients' covariance.
  double sd_run = 0;            ///< Standard deviation of one new run: the mesh scatter is added.
  double lower = 0, upper = 0;  ///< Interval for one new run at the level asked for.
};

/// Fits the response; runs without a value are left out. Throws Error(config) naming the response where too few are
/// left, where there are not as many values as runs, or where a logarithm is asked of a value that is not positive.
ResponseModel fit_response(const Design& design, const Response& response, const ModelOptions& options);

/// The runs with a value, on the fitted scale.
Observations observe(const Design& design, const Response& response);

/// The reduced model's value at coded levels x.
double predict_value(const ResponseModel& model, const std::vector<double>& x);

/// Its derivatives by the coded factors.
std::vector<double> predict_gradient(const ResponseModel& model, const std::vector<double>& x);

/// Value and uncertainty, Eqs. (S14)-(S16); `level` of the interval, e.g. 0.95.
Prediction predict(const ResponseModel& model, const std::vector<double>& x, double level);

}  // namespace asperity
