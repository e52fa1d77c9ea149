#include "core/confrontation/bounded_least_squares.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd bounded_least_squares(const MatrixXd& columns, const VectorXd& residual, const VectorXd& least,
                               const VectorXd& greatest, double ridge) {
  constexpr int kMostSweeps = 10000;
  constexpr double kSmallChange = 1e-10;
  const MatrixXd normal = columns.transpose() * columns + ridge * MatrixXd::Identity(columns.cols(), columns.cols());
  const VectorXd right = columns.transpose() * residual;
  VectorXd x = VectorXd::Zero(columns.cols());
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    double most = 0.0;
    for (Index i = 0; i < x.size(); ++i) {
      if (normal(i, i) <= 0.0) continue;
      const double before = x(i);
      const double best = before + (right(i) - normal.row(i).dot(x)) / normal(i, i);
      x(i) = std::clamp(best, least(i), greatest(i));
      most = std::max(most, std::abs(x(i) - before));
    }
    if (most < kSmallChange) break;
  }
  return x;
}

}  // namespace asperity
