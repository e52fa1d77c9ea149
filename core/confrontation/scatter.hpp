#pragma once
#include <Eigen/Core>
#include <vector>

#include "core/base/random.hpp"
#include "core/confrontation/comparison.hpp"
#include "core/confrontation/noise_model.hpp"

namespace asperity {

/// What is known of the scatter behind a comparison.
struct Scatter {
  std::vector<Eigen::MatrixXd> run;  ///< Covariance of one run, test by test.
  Eigen::VectorXd specimen_factor;   ///< Specimens' standard deviation over the runs', 1 or more; Eq. (N9).
  Eigen::MatrixXd effects;           ///< Covariance by what the parameters' effects are not known, Eq. (N20).
  Eigen::MatrixXd covariance;        ///< Of data less model, Eq. (N10), effects' error included.
};

/// Where the base stays at the parameters of its runs.
Scatter scatter_of(const Comparison& comparison, const NoiseOptions& options);

/// Where calibration moves the base by `coded` steps from its runs, Eq. (N20).
Scatter scatter_at(const Comparison& comparison, const Eigen::VectorXd& coded, const NoiseOptions& options);

/// The whole comparison done once more without any discrepancy: other specimens, other meshes, other instruments.
struct Repetition {
  Eigen::VectorXd difference;  ///< Data less model.
  Eigen::VectorXd
      least_difference;        ///< The same by the meshes' own scatter alone: no floors, instruments, rougher rock.
  Eigen::MatrixXd covariance;  ///< As it would have been estimated.
};

/// Draws rows of runs with replacement (residual bootstrap), test by test; instruments' errors are normal.
Repetition repeat(const Comparison& comparison, const Scatter& scatter, const NoiseOptions& options,
                  RandomStream& random);

/// Error of a mean of differences over common meshes, drawn by choosing meshes with replacement test by test.
Eigen::VectorXd drawn_error(const Comparison& comparison, const Eigen::MatrixXd& rows, RandomStream& random);

}  // namespace asperity
