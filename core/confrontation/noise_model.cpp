#include "core/confrontation/noise_model.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace asperity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Unbiased variance of a column whose mean is zero, and the variance of that estimate.
struct Variance {
  double value = 0, error = 0;
};

Variance variance_of(const VectorXd& column) {
  const double n = static_cast<double>(column.size());
  const VectorXd square = column.array().square();
  const double mean = square.mean();
  return {n / (n - 1.0) * mean, n / std::pow(n - 1.0, 3) * (square.array() - mean).square().sum()};
}

/// The variances of one kind of feature over all tests.
struct Group {
  std::vector<double> values;
  double errors = 0;
};

/// Eq. (N4): share by which a group's variances are drawn to their median.
double variance_shrinkage(const Group& group) {
  const double target = median(group.values);
  double spread = 0.0;
  for (const double v : group.values) spread += (v - target) * (v - target);
  if (spread <= 0.0) return 1.0;
  return std::min(1.0, group.errors / spread);
}

std::map<int, Group> groups_of(const std::vector<NoiseBlock>& blocks) {
  std::map<int, Group> groups;
  for (const NoiseBlock& block : blocks) {
    for (Index c = 0; c < block.rows.cols(); ++c) {
      const Variance v = variance_of(block.rows.col(c));
      Group& group = groups[block.group[static_cast<std::size_t>(c)]];
      group.values.push_back(v.value);
      group.errors += v.error;
    }
  }
  return groups;
}

VectorXd steadied_deviations(const NoiseBlock& block, const std::map<int, Group>& groups) {
  VectorXd sd(block.rows.cols());
  for (Index c = 0; c < sd.size(); ++c) {
    const Group& group = groups.at(block.group[static_cast<std::size_t>(c)]);
    const double share = variance_shrinkage(group);
    const double variance = (1.0 - share) * variance_of(block.rows.col(c)).value + share * median(group.values);
    sd(c) = std::max(std::sqrt(variance), block.floor(c));
  }
  return sd;
}

/// Columns over their deviations; a column without scatter stays zero.
MatrixXd standardised(const MatrixXd& rows) {
  MatrixXd scaled = rows;
  for (Index c = 0; c < rows.cols(); ++c) {
    const double sd = std::sqrt(variance_of(rows.col(c)).value);
    if (sd > 0.0) scaled.col(c) /= sd;
  }
  return scaled;
}

MatrixXd steadied_correlations(const MatrixXd& rows, const NoiseOptions& options) {
  const MatrixXd scaled = standardised(rows);
  MatrixXd correlation = scaled.transpose() * scaled / static_cast<double>(rows.rows() - 1);
  correlation *= 1.0 - std::max(options.least_ridge, correlation_shrinkage(rows));
  correlation.diagonal().setOnes();
  return correlation;
}

}  // namespace

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double correlation_shrinkage(const MatrixXd& rows) {
  const MatrixXd scaled = standardised(rows);
  const double n = static_cast<double>(rows.rows());
  double errors = 0.0, squares = 0.0;
  for (Index a = 0; a < scaled.cols(); ++a) {
    for (Index b = 0; b < a; ++b) {
      const VectorXd product = scaled.col(a).array() * scaled.col(b).array();
      const double mean = product.mean(), correlation = n / (n - 1.0) * mean;
      errors += n / std::pow(n - 1.0, 3) * (product.array() - mean).square().sum();
      squares += correlation * correlation;
    }
  }
  return squares > 0.0 ? std::min(1.0, errors / squares) : 1.0;
}

std::vector<MatrixXd> run_covariances(const std::vector<NoiseBlock>& blocks, const NoiseOptions& options) {
  const std::map<int, Group> groups = groups_of(blocks);
  std::vector<MatrixXd> covariances;
  for (const NoiseBlock& block : blocks) {
    const VectorXd sd = steadied_deviations(block, groups);
    covariances.push_back(sd.asDiagonal() * steadied_correlations(block.rows, options) * sd.asDiagonal());
  }
  return covariances;
}

}  // namespace asperity
