#include "core/calibration/linear_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <openturns/DistFunc.hxx>
#include <openturns/LeastSquaresMethod.hxx>

#include "core/base/error.hpp"

namespace asperity {
namespace {

constexpr double kRounding = 1e-12;     // of the largest response: 20 terms of double precision, with room
constexpr double kFullLeverage = 1e-9;  // 1 - h below this: the run's residual is rounding
constexpr double kIndistinct = 1e-10;   // tolerated variance inflation of a term's coefficient is 1e10

OT::Matrix design_matrix(const Observations& observed, const std::vector<Term>& terms) {
  OT::Matrix matrix(observed.y.size(), terms.size());
  for (std::size_t i = 0; i < observed.y.size(); ++i) {
    for (std::size_t j = 0; j < terms.size(); ++j) matrix(i, j) = term_value(terms[j], observed.x[i]);
  }
  return matrix;
}

Error too_few(const Observations& observed, std::size_t terms) {
  return {ErrorKind::config,
          {{"/responses/" + observed.name, "has too few good runs for the terms fitted to it",
            std::to_string(observed.y.size()), std::to_string(terms + 1) + " or more",
            "repeat the bad runs, or calibrate with fewer factors"}}};
}

Error indistinct(const Observations& observed) {
  return {ErrorKind::config,
          {{"/responses/" + observed.name, "its good runs cannot tell the model's terms apart",
            std::to_string(observed.y.size()) + " runs", "", "repeat the bad runs"}}};
}

/// Sum over the columns of the square of each term: what its coefficient would know, were the terms orthogonal.
double column_square(const OT::Matrix& matrix, std::size_t column) {
  double sum = 0.0;
  for (std::size_t i = 0; i < matrix.getNbRows(); ++i) sum += matrix(i, column) * matrix(i, column);
  return sum;
}

void require_distinct(const Observations& observed, const OT::Matrix& matrix, const OT::CovarianceMatrix& inverse) {
  for (std::size_t j = 0; j < matrix.getNbColumns(); ++j) {
    const double information = 1.0 / (inverse(j, j) * column_square(matrix, j));
    if (!(information > kIndistinct)) throw indistinct(observed);
  }
}

/// Coefficients and (X'X)^-1.
struct Solved {
  OT::Point coefficients;
  OT::CovarianceMatrix gram_inverse;
};

Solved solve(const Observations& observed, const OT::Matrix& matrix) {
  for (std::size_t j = 0; j < matrix.getNbColumns(); ++j) {
    if (column_square(matrix, j) == 0.0) throw indistinct(observed);
  }
  OT::Point right(observed.y.size());
  std::copy(observed.y.begin(), observed.y.end(), right.begin());
  try {
    OT::LeastSquaresMethod method = OT::LeastSquaresMethod::Build("QR", matrix);
    Solved solved;
    solved.coefficients = method.solve(right);  // first: the inverse is that of the decomposition made here
    solved.gram_inverse = method.getGramInverse();
    require_distinct(observed, matrix, solved.gram_inverse);
    return solved;
  } catch (const OT::Exception&) {
    throw indistinct(observed);
  }
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

void fill_matrices(LinearFit& fit, const OT::Matrix& matrix, const OT::CovarianceMatrix& inverse) {
  const std::size_t n = matrix.getNbRows(), p = matrix.getNbColumns();
  fit.gram_inverse.resize(p * p);
  fit.projection.resize(p * n);
  fit.leverages.assign(n, 0.0);
  for (std::size_t i = 0; i < p; ++i) {
    for (std::size_t j = 0; j < p; ++j) fit.gram_inverse[i * p + j] = inverse(i, j);
    for (std::size_t r = 0; r < n; ++r) {
      double sum = 0.0;
      for (std::size_t j = 0; j < p; ++j) sum += inverse(i, j) * matrix(r, j);
      fit.projection[i * n + r] = sum;
      fit.leverages[r] += sum * matrix(r, i);
    }
  }
}

void fill_residuals(LinearFit& fit, const Observations& observed) {
  const double mean = mean_of(observed.y);
  for (std::size_t i = 0; i < observed.y.size(); ++i) {
    fit.fitted.push_back(evaluate(fit, observed.x[i]));
    fit.residuals.push_back(observed.y[i] - fit.fitted[i]);
    fit.residual_sum_of_squares += fit.residuals[i] * fit.residuals[i];
    fit.total_sum_of_squares += (observed.y[i] - mean) * (observed.y[i] - mean);
  }
}

double largest_magnitude(const std::vector<double>& values) {
  double largest = 0.0;
  for (double v : values) largest = std::max(largest, std::abs(v));
  return largest;
}

/// Eq. (S5) and Eq. (S6).
void fill_tests(LinearFit& fit, double largest) {
  fit.residual_sd = std::max(std::sqrt(fit.residual_sum_of_squares / fit.residual_df), kRounding * largest);
  const std::size_t p = fit.terms.size();
  for (std::size_t i = 0; i < p; ++i) {
    const double error = fit.residual_sd * std::sqrt(fit.gram_inverse[i * p + i]);
    const double t = error > 0.0 ? fit.coefficients[i] / error : 0.0;
    fit.standard_errors.push_back(error);
    fit.t_values.push_back(t);
    fit.p_values.push_back(2.0 * OT::DistFunc::pStudent(fit.residual_df, std::abs(t), true));
  }
}

/// Eq. (S7) and Eq. (S8).
void fill_determination(LinearFit& fit) {
  const double total = fit.total_sum_of_squares;
  const auto n = static_cast<double>(fit.rows.size());
  double press = 0.0;
  bool full = false;
  for (std::size_t i = 0; i < fit.rows.size(); ++i) {
    const double free = 1.0 - fit.leverages[i];
    full = full || free < kFullLeverage;
    press += fit.residuals[i] * fit.residuals[i] / (free * free);
  }
  fit.r2 = 1.0 - fit.residual_sum_of_squares / total;
  fit.r2_adjusted = 1.0 - fit.residual_sum_of_squares / fit.residual_df * (n - 1.0) / total;
  if (!full) fit.r2_predicted = 1.0 - press / total;
}

/// Eq. (S9).
void fill_studentised(LinearFit& fit) {
  const double df = fit.residual_df;
  for (std::size_t i = 0; i < fit.rows.size(); ++i) {
    const double free = 1.0 - fit.leverages[i];
    const double square = fit.residuals[i] * fit.residuals[i] / free;
    const double without = (df * fit.residual_sd * fit.residual_sd - square) / (df - 1.0);
    const bool told = free >= kFullLeverage && fit.residual_df > 1 && without > 0.0;
    fit.studentised.push_back(told ? fit.residuals[i] / std::sqrt(without * free)
                                   : std::numeric_limits<double>::quiet_NaN());
  }
}

}  // namespace

LinearFit fit_terms(const Observations& observed, const std::vector<Term>& terms) {
  const std::size_t n = observed.y.size(), p = terms.size();
  if (n < p + 1) throw too_few(observed, p);
  const OT::Matrix matrix = design_matrix(observed, terms);
  const Solved solved = solve(observed, matrix);
  LinearFit fit;
  fit.terms = terms;
  fit.rows = observed.rows;
  fit.coefficients.assign(solved.coefficients.begin(), solved.coefficients.end());
  fit.residual_df = static_cast<int>(n - p);
  fill_matrices(fit, matrix, solved.gram_inverse);
  fill_residuals(fit, observed);
  fill_tests(fit, largest_magnitude(observed.y));
  fill_determination(fit);
  fill_studentised(fit);
  return fit;
}

std::optional<std::size_t> index_of(const LinearFit& fit, Term term) {
  const auto found = std::find(fit.terms.begin(), fit.terms.end(), term);
  if (found == fit.terms.end()) return std::nullopt;
  return static_cast<std::size_t>(found - fit.terms.begin());
}

std::vector<double> term_values(const LinearFit& fit, const std::vector<double>& x) {
  std::vector<double> values;
  for (const Term& term : fit.terms) values.push_back(term_value(term, x));
  return values;
}

double evaluate(const LinearFit& fit, const std::vector<double>& x) {
  double sum = 0.0;
  for (std::size_t i = 0; i < fit.terms.size(); ++i) sum += fit.coefficients[i] * term_value(fit.terms[i], x);
  return sum;
}

}  // namespace asperity
