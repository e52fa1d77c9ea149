#pragma once
#include <Eigen/Core>
#include <vector>

namespace asperity {

/// How a covariance of few runs is steadied.
struct NoiseOptions {
  double least_ridge = 0.2;  ///< Least share by which correlations are drawn to zero.
};

/// One test's block of features, for the estimation of scatter.
struct NoiseBlock {
  Eigen::MatrixXd rows;    ///< Runs by features, each column's mean taken off.
  std::vector<int> group;  ///< By column: features of one kind share a number over all blocks.
  Eigen::VectorXd floor;   ///< By column: least standard deviation.
};

/// Covariance of one run, block by block: variances drawn to those of like features and correlations to zero, by the
/// intensities of Schaefer & Strimmer, Eqs. (N4)-(N6); floors come last.
std::vector<Eigen::MatrixXd> run_covariances(const std::vector<NoiseBlock>& blocks, const NoiseOptions& options);

/// Of at least one value; of an even number the mean of the middle two.
double median(std::vector<double> values);

/// Share by which each correlation of the rows is drawn to zero, Eq. (N5), 0 to 1.
double correlation_shrinkage(const Eigen::MatrixXd& rows);

}  // namespace asperity
