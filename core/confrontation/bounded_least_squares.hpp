#pragma once
#include <Eigen/Core>

namespace asperity {

/// The x in [least, greatest] that minimises |residual - columns x|^2 + ridge |x|^2, by coordinate descent. Each
/// entry of `least` is at most 0 and each of `greatest` at least 0: the descent starts from x = 0.
Eigen::VectorXd bounded_least_squares(const Eigen::MatrixXd& columns, const Eigen::VectorXd& residual,
                                      const Eigen::VectorXd& least, const Eigen::VectorXd& greatest, double ridge);

}  // namespace asperity
