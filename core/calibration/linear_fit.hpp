#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/calibration/terms.hpp"

/// Least squares of one response on given terms.
namespace asperity {

/// What was observed of one response: n good runs.
struct Observations {
  std::string name;                    ///< The response, for errors.
  std::vector<std::size_t> rows;       ///< Rows of the design.
  std::vector<std::vector<double>> x;  ///< Coded levels, n rows of k.
  std::vector<double> y;
};

/// A fit of p terms to n runs; arrays of p are in order of `terms`, arrays of n in order of `rows`.
struct LinearFit {
  std::vector<Term> terms;
  std::vector<std::size_t> rows;
  std::vector<double> coefficients, standard_errors, t_values, p_values;  ///< p each.
  std::vector<double> gram_inverse;                                       ///< (X'X)^-1, p by p.
  std::vector<double> projection;                    ///< (X'X)^-1 X', p by n in rows of n: coefficients = projection y.
  std::vector<double> fitted, residuals, leverages;  ///< n each.
  std::vector<double> studentised;  ///< Externally studentised residuals, n; NaN where a run has leverage 1.
  double residual_sum_of_squares = 0, total_sum_of_squares = 0;
  int residual_df = 0;
  double residual_sd = 0;  ///< Scatter of one run about the fit.
  double r2 = 0, r2_adjusted = 0;
  std::optional<double> r2_predicted;  ///< None where a run has leverage 1: it cannot be predicted by the others.
};

/// Ordinary least squares by QR, Eqs. (S4)-(S9). A residual scatter below 1e-12 of the largest response counts as that
/// much: it is the rounding of exact data, about which tests say nothing. Throws Error(config) naming the response
/// where there are too few runs, or where the runs cannot tell two terms apart.
LinearFit fit_terms(const Observations& observed, const std::vector<Term>& terms);

/// Place of a term in the fit, if it is there.
std::optional<std::size_t> index_of(const LinearFit& fit, Term term);

/// The fit at coded levels x.
double evaluate(const LinearFit& fit, const std::vector<double>& x);

/// Values of the fit's terms at x.
std::vector<double> term_values(const LinearFit& fit, const std::vector<double>& x);

}  // namespace asperity
