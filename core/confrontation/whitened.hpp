#pragma once
#include <Eigen/Core>
#include <vector>

#include "core/confrontation/comparison.hpp"

namespace asperity {

/// Differences in standard deviations, with what calibration can absorb taken out: r = P L^-1 x, P = I - Q Q',
/// Q = orth(L^-1 J), covariance = L L'; Eq. (N11).
class WhitenedFrame {
 public:
  /// Directions of `nuisance` whose unit moves the data by less than a fifth of a standard deviation are not taken out:
  /// such a parameter is not determined. Throws Error(numerical) where the covariance is not positive definite.
  WhitenedFrame(const Eigen::MatrixXd& covariance, const Eigen::MatrixXd& nuisance);

  Eigen::MatrixXd whiten(const Eigen::MatrixXd& columns) const;     ///< L^-1 x
  Eigen::MatrixXd project(const Eigen::MatrixXd& columns) const;    ///< P L^-1 x
  Eigen::VectorXd unwhiten(const Eigen::VectorXd& standard) const;  ///< L x
  /// Least-squares coefficients of `columns` for a difference; directions without effect stay 0.
  Eigen::VectorXd solve(const Eigen::MatrixXd& columns, const Eigen::VectorXd& difference) const;
  /// (X' X)^-1 of the whitened columns: the covariance of their coefficients, directions without effect held at 0.
  Eigen::MatrixXd information_inverse(const Eigen::MatrixXd& columns) const;
  double log_determinant() const;                             ///< ln det of the covariance.
  Eigen::Index absorbed() const { return nuisance_.cols(); }  ///< Number of directions taken out.

 private:
  Eigen::MatrixXd lower_, nuisance_;
};

/// Calibration of the base by the compared features, within what is believed of each parameter.
struct BaseFit {
  Eigen::VectorXd coded, error;  ///< Parameters and their standard deviations, in steps.
  Eigen::MatrixXd covariance;    ///< Of the parameters, in steps.
  std::vector<bool> determined;  ///< False: the data do not move it; it stays.
  std::vector<bool> limited;     ///< At the end of what is believed.
  Eigen::VectorXd difference;    ///< Data less the model there.
  Eigen::MatrixXd jacobian;      ///< There.
  Eigen::MatrixXd absorbing;     ///< The same without parameters at a limit, which absorb nothing more: zero columns.
};

/// Generalised least squares, Eq. (N12).
BaseFit calibrate_base(const Comparison& comparison, const Eigen::MatrixXd& covariance,
                       const std::vector<CalibratedParameter>& parameters);

/// Amplitudes of one or two columns (already projected) that explain a projected residual best, each within its bounds,
/// and what is left; Eq. (N13).
struct AmplitudeFit {
  Eigen::VectorXd amplitude;
  double misfit = 0;
};
AmplitudeFit fit_amplitudes(const Eigen::VectorXd& residual, const Eigen::MatrixXd& columns,
                            const Eigen::VectorXd& least, const Eigen::VectorXd& greatest);

}  // namespace asperity
