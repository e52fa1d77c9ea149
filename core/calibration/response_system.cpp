#include "core/calibration/response_system.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include "core/base/random.hpp"

namespace asperity {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Places of the runs that both fits use: (place in a, place in b).
std::vector<std::pair<std::size_t, std::size_t>> common_runs(const LinearFit& a, const LinearFit& b) {
  std::vector<std::pair<std::size_t, std::size_t>> common;
  for (std::size_t i = 0; i < a.rows.size(); ++i) {
    const auto found = std::lower_bound(b.rows.begin(), b.rows.end(), a.rows[i]);
    if (found != b.rows.end() && *found == a.rows[i]) {
      common.emplace_back(i, static_cast<std::size_t>(found - b.rows.begin()));
    }
  }
  return common;
}

/// Correlation of two fits' residuals over their common runs; 0 where there is no scatter.
double residual_correlation(const LinearFit& a, const LinearFit& b) {
  double product = 0.0, square_a = 0.0, square_b = 0.0;
  for (const auto& [i, j] : common_runs(a, b)) {
    product += a.residuals[i] * b.residuals[j];
    square_a += a.residuals[i] * a.residuals[i];
    square_b += b.residuals[j] * b.residuals[j];
  }
  const double scale = std::sqrt(square_a * square_b);
  return scale > 0.0 ? product / scale : 0.0;
}

/// A square root L of the covariance (L L' = S) that also stands for one that is only semi-definite, or, with different
/// runs missing, not quite that.
MatrixXd square_root(const std::vector<double>& covariance, std::size_t m) {
  const Eigen::Map<const RowMatrix> matrix(covariance.data(), static_cast<Eigen::Index>(m),
                                           static_cast<Eigen::Index>(m));
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(matrix);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

std::vector<double> correlated(RandomStream& random, const MatrixXd& root, double scale) {
  VectorXd white(root.cols());
  for (Eigen::Index i = 0; i < white.size(); ++i) white(i) = random.normal();
  const VectorXd drawn = scale * (root * white);
  return {drawn.begin(), drawn.end()};
}

/// sqrt(df / chi2_df): how much larger the true scatter may be than the one seen.
double scatter_factor(RandomStream& random, int df) {
  double chi2 = 0.0;
  for (int i = 0; i < df; ++i) {
    const double z = random.normal();
    chi2 += z * z;
  }
  return std::sqrt(df / chi2);
}

/// Coefficients fitted to the old predictions plus scatter: as the fit is linear, the old ones plus its projection of
/// the scatter.
void redraw(LinearFit& fit, const std::vector<std::vector<double>>& scatter, std::size_t response) {
  const std::size_t n = fit.rows.size();
  for (std::size_t i = 0; i < fit.terms.size(); ++i) {
    for (std::size_t r = 0; r < n; ++r) {
      fit.coefficients[i] += fit.projection[i * n + r] * scatter[fit.rows[r]][response];
    }
  }
}

}  // namespace

ResponseSystem::ResponseSystem(std::vector<ResponseModel> models, std::vector<Target> targets)
    : models_(std::move(models)), targets_(std::move(targets)) {
  assert(!models_.empty() && models_.size() == targets_.size());
  for (const Term& term : models_.front().full.terms) {
    if (kind_of(term) == TermKind::linear) ++factors_;
  }
  find_scatter();
  find_cross_products();
}

void ResponseSystem::find_scatter() {
  const std::size_t m = models_.size();
  scatter_.assign(m * m, 0.0);
  for (std::size_t r = 0; r < m; ++r) {
    for (std::size_t s = 0; s < m; ++s) {
      const LinearFit &a = models_[r].reduced, &b = models_[s].reduced;
      scatter_[r * m + s] = (r == s ? 1.0 : residual_correlation(a, b)) * a.residual_sd * b.residual_sd;
    }
  }
}

void ResponseSystem::find_cross_products() {
  for (const ResponseModel& first : models_) {
    for (const ResponseModel& second : models_) {
      const LinearFit &a = first.reduced, &b = second.reduced;
      const std::size_t p = a.terms.size(), q = b.terms.size(), n = a.rows.size(), o = b.rows.size();
      std::vector<double> product(p * q, 0.0);
      for (const auto& [i, j] : common_runs(a, b)) {
        for (std::size_t u = 0; u < p; ++u) {
          for (std::size_t v = 0; v < q; ++v) product[u * q + v] += a.projection[u * n + i] * b.projection[v * o + j];
        }
      }
      cross_.push_back(std::move(product));
    }
  }
}

std::vector<double> ResponseSystem::values(const std::vector<double>& x) const {
  std::vector<double> y;
  for (const ResponseModel& model : models_) y.push_back(predict_value(model, x));
  return y;
}

std::vector<double> ResponseSystem::jacobian(const std::vector<double>& x) const {
  std::vector<double> rows;
  for (const ResponseModel& model : models_) {
    const std::vector<double> gradient = predict_gradient(model, x);
    rows.insert(rows.end(), gradient.begin(), gradient.end());
  }
  return rows;
}

std::vector<double> ResponseSystem::misses(const std::vector<double>& x) const {
  std::vector<double> miss = values(x);
  for (std::size_t r = 0; r < miss.size(); ++r) {
    miss[r] = (miss[r] - targets_[r].value) / (targets_[r].tolerance * std::abs(targets_[r].value));
  }
  return miss;
}

std::vector<double> ResponseSystem::covariance(const std::vector<double>& x) const {
  const std::size_t m = models_.size();
  std::vector<std::vector<double>> terms;
  std::vector<double> scale;  // derivative of the response by its fitted scale
  for (const ResponseModel& model : models_) {
    terms.push_back(term_values(model.reduced, x));
    scale.push_back(model.transform == Transform::logarithm ? predict_value(model, x) : 1.0);
  }
  std::vector<double> covariance(m * m);
  for (std::size_t r = 0; r < m; ++r) {
    for (std::size_t s = 0; s < m; ++s) {
      const std::vector<double>& product = cross_[r * m + s];
      double sum = 0.0;
      for (std::size_t u = 0; u < terms[r].size(); ++u) {
        for (std::size_t v = 0; v < terms[s].size(); ++v) {
          sum += terms[r][u] * product[u * terms[s].size() + v] * terms[s][v];
        }
      }
      covariance[r * m + s] = scale[r] * scale[s] * scatter_[r * m + s] * sum;
    }
    covariance[r * m + r] += targets_[r].standard_error * targets_[r].standard_error;
  }
  return covariance;
}

int ResponseSystem::residual_df() const {
  int fewest = models_.front().reduced.residual_df;
  for (const ResponseModel& model : models_) fewest = std::min(fewest, model.reduced.residual_df);
  return fewest;
}

ResponseSystem ResponseSystem::redrawn(std::uint64_t seed, std::size_t draw) const {
  RandomStream random(seed, "bootstrap/" + std::to_string(draw));
  const MatrixXd root = square_root(scatter_, models_.size());
  const double scale = scatter_factor(random, residual_df());
  std::size_t runs = 0;
  for (const ResponseModel& model : models_) runs = std::max(runs, model.full.rows.back() + 1);
  std::vector<std::vector<double>> scatter;
  for (std::size_t i = 0; i < runs; ++i) scatter.push_back(correlated(random, root, scale));
  ResponseSystem other = *this;
  for (std::size_t r = 0; r < models_.size(); ++r) {
    redraw(other.models_[r].reduced, scatter, r);
    other.targets_[r].value += targets_[r].standard_error * random.normal();
  }
  return other;
}

}  // namespace asperity
