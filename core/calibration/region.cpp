#include "core/calibration/region.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <openturns/DistFunc.hxx>
#include <openturns/FisherSnedecor.hxx>

namespace asperity {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr double kRidge = 1e-12;  // of a response's variance: responses whose scatter is the same but for rounding

MatrixXd matrix_of(const std::vector<double>& values, std::size_t rows) {
  const auto m = static_cast<Eigen::Index>(rows);
  return Eigen::Map<const RowMatrix>(values.data(), m, static_cast<Eigen::Index>(values.size()) / m);
}

/// Lower triangular root of the responses' covariance at x.
MatrixXd root_of_covariance(const ResponseSystem& system, const std::vector<double>& x) {
  MatrixXd covariance = matrix_of(system.covariance(x), system.targets().size());
  covariance.diagonal() *= 1.0 + kRidge;
  return covariance.llt().matrixL();
}

double student_quantile(double probability, int df) { return OT::DistFunc::qStudent(df, probability); }

/// Factor of the standard deviation for an interval of one parameter, and of k at once by Bonferroni's inequality.
double reach_of_one(double level, int df) { return student_quantile(0.5 + 0.5 * level, df); }
double reach_of_all(double level, int df, std::size_t k) {
  return student_quantile(1.0 - 0.5 * (1.0 - level) / static_cast<double>(k), df);
}

/// Eq. (S24).
void fill_directions(ConfidenceRegion& region, const MatrixXd& vectors, const VectorXd& values, double limit) {
  for (Eigen::Index i = 0; i < vectors.cols(); ++i) {
    const double value = i < values.size() ? values(i) : 0.0;
    region.singular_values.push_back(value);
    region.directions.emplace_back(vectors.col(i).begin(), vectors.col(i).end());
    region.direction_determined.push_back(value > 0.0 && 1.0 / value <= limit);
  }
}

/// Eq. (S23). No interval along a direction is longer than the design to either side: parameters further off are not
/// asked for, and a direction that no response tells would else make every parameter that it leans on unbounded.
MatrixXd parameter_covariance(const ConfidenceRegion& region, double alpha) {
  const auto k = static_cast<Eigen::Index>(region.directions.size());
  MatrixXd covariance = MatrixXd::Zero(k, k);
  for (std::size_t i = 0; i < region.directions.size(); ++i) {
    const Eigen::Map<const VectorXd> v(region.directions[i].data(), k);
    const double sd = 1.0 / std::max(region.singular_values[i], reach_of_one(region.level, region.df) / (2.0 * alpha));
    covariance += sd * sd * v * v.transpose();
  }
  return covariance;
}

void fill_intervals(ConfidenceRegion& region, const std::vector<double>& x, double alpha) {
  const std::size_t k = x.size();
  const double one = reach_of_one(region.level, region.df), all = reach_of_all(region.level, region.df, k);
  for (std::size_t j = 0; j < k; ++j) {
    const double sd = std::sqrt(region.covariance[j * k + j]);
    region.interval_lower.push_back(x[j] - one * sd);
    region.interval_upper.push_back(x[j] + one * sd);
    region.lower.push_back(x[j] - all * sd);
    region.upper.push_back(x[j] + all * sd);
    region.determined.push_back(region.interval_lower[j] >= -alpha && region.interval_upper[j] <= alpha);
  }
}

}  // namespace

ConfidenceRegion confidence_region(const ResponseSystem& system, const std::vector<double>& x, double level,
                                   double alpha) {
  ConfidenceRegion region;
  region.level = level;
  region.df = system.residual_df();
  const MatrixXd root = root_of_covariance(system, x);
  const MatrixXd jacobian = matrix_of(system.jacobian(x), system.targets().size());
  const MatrixXd whitened = root.triangularView<Eigen::Lower>().solve(jacobian);
  const Eigen::JacobiSVD<MatrixXd> svd(whitened, Eigen::ComputeFullV);
  fill_directions(region, svd.matrixV(), svd.singularValues(), alpha / reach_of_one(level, region.df));
  const MatrixXd covariance = parameter_covariance(region, alpha);
  region.covariance.assign(covariance.data(), covariance.data() + covariance.size());
  fill_intervals(region, x, alpha);
  return region;
}

bool in_joint_region(const ResponseSystem& system, const std::vector<double>& x, double level) {
  const MatrixXd root = root_of_covariance(system, x);
  const std::vector<double> values = system.values(x);
  const auto m = static_cast<int>(values.size());
  VectorXd miss(m);
  for (std::size_t r = 0; r < values.size(); ++r) {
    miss(static_cast<Eigen::Index>(r)) = values[r] - system.targets()[r].value;
  }
  const double square = root.triangularView<Eigen::Lower>().solve(miss).squaredNorm();
  const int df = system.residual_df(), left = df - m + 1;
  if (left < 1) return true;  // fewer degrees of freedom than responses bound nothing
  const double quantile = OT::FisherSnedecor(m, left).computeQuantile(level)[0];
  return square <= static_cast<double>(m) * df / left * quantile;
}

}  // namespace asperity
