#include "core/calibration/response_model.hpp"

#include <cmath>
#include <openturns/DistFunc.hxx>

#include "core/base/error.hpp"
#include "core/config/schema_lookup.hpp"

namespace asperity {
namespace {

double fitted_scale(const Response& response, std::size_t row) {
  const double value = response.values[row];
  if (response.transform == Transform::none) return value;
  if (value > 0.0) return std::log(value);
  throw Error(ErrorKind::config, {{"/responses/" + response.name + "/" + std::to_string(row), "has no logarithm",
                                   number_text(value), "above 0", "model the response as it is"}});
}

void require_one_value_a_run(const Design& design, const Response& response) {
  if (response.values.size() == design.coded.size()) return;
  throw Error(ErrorKind::config, {{"/responses/" + response.name, "has not one value a run",
                                   std::to_string(response.values.size()), std::to_string(design.coded.size()), ""}});
}

/// x' (X'X)^-1 x, the variance of the fit at x in units of the residual variance.
double relative_variance(const LinearFit& fit, const std::vector<double>& x) {
  const std::vector<double> f = term_values(fit, x);
  double sum = 0.0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    for (std::size_t j = 0; j < f.size(); ++j) sum += f[i] * fit.gram_inverse[i * f.size() + j] * f[j];
  }
  return sum;
}

}  // namespace

Observations observe(const Design& design, const Response& response) {
  require_one_value_a_run(design, response);
  Observations observed{response.name, {}, {}, {}};
  for (std::size_t row = 0; row < design.coded.size(); ++row) {
    if (!std::isfinite(response.values[row])) continue;
    observed.rows.push_back(row);
    observed.x.push_back(design.coded[row]);
    observed.y.push_back(fitted_scale(response, row));
  }
  return observed;
}

ResponseModel fit_response(const Design& design, const Response& response, const ModelOptions& options) {
  const Observations observed = observe(design, response);
  const LinearFit full = fit_terms(observed, quadratic_terms(design.factors.size()));
  Elimination reduced = eliminate(observed, full, options.elimination_level, options.hierarchy);
  return {response.name,
          response.transform,
          full,
          std::move(reduced.fit),
          std::move(reduced.eliminated),
          analyse_variance(observed, full),
          check_residuals(full)};
}

double predict_value(const ResponseModel& model, const std::vector<double>& x) {
  const double value = evaluate(model.reduced, x);
  return model.transform == Transform::logarithm ? std::exp(value) : value;
}

std::vector<double> predict_gradient(const ResponseModel& model, const std::vector<double>& x) {
  const double scale = model.transform == Transform::logarithm ? predict_value(model, x) : 1.0;
  std::vector<double> gradient(x.size(), 0.0);
  for (std::size_t j = 0; j < x.size(); ++j) {
    for (std::size_t i = 0; i < model.reduced.terms.size(); ++i) {
      gradient[j] +=
          scale * model.reduced.coefficients[i] * term_derivative(model.reduced.terms[i], x, static_cast<int>(j));
    }
  }
  return gradient;
}

Prediction predict(const ResponseModel& model, const std::vector<double>& x, double level) {
  const LinearFit& fit = model.reduced;
  const double mean = evaluate(fit, x), variance = relative_variance(fit, x);
  const double sd_mean = fit.residual_sd * std::sqrt(variance);
  const double sd_run = fit.residual_sd * std::sqrt(1.0 + variance);
  const double reach = OT::DistFunc::qStudent(fit.residual_df, 0.5 + 0.5 * level) * sd_run;
  if (model.transform == Transform::none) return {mean, sd_mean, sd_run, mean - reach, mean + reach};
  const double value = std::exp(mean);
  return {value, value * sd_mean, value * sd_run, std::exp(mean - reach), std::exp(mean + reach)};
}

}  // namespace asperity
