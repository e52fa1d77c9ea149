#include <Eigen/Dense>

#include "core/calibration/optimum.hpp"
#include "core/calibration/solution_curve.hpp"

namespace asperity {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr int kMostSteps = 200;
constexpr double kSmallStep = 1e-12;  // coded: the step where double precision ends
constexpr double kLostAt = 1e3;       // coded: a walk this far from the design does not come back
constexpr double kRank = 1e-6;        // of the largest singular value: below it a direction changes no response
constexpr double kMet = 1e-8;         // of a tolerance: a target met to rounding

/// Misses and their derivatives at x.
struct Linear {
  VectorXd misses;
  MatrixXd jacobian;
};

VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

VectorXd misses_at(const ResponseSystem& system, const VectorXd& x) {
  return vector_of(system.misses({x.begin(), x.end()}));
}

Linear linearised(const ResponseSystem& system, const VectorXd& x) {
  const std::vector<double> rows = system.jacobian({x.begin(), x.end()});
  const auto m = static_cast<Eigen::Index>(system.targets().size());
  Linear linear{misses_at(system, x), Eigen::Map<const RowMatrix>(rows.data(), m, x.size())};
  for (Eigen::Index r = 0; r < m; ++r) {
    const Target& target = system.targets()[static_cast<std::size_t>(r)];
    linear.jacobian.row(r) /= target.tolerance * std::abs(target.value);
  }
  return linear;
}

/// Right singular vectors of the directions that change no response.
MatrixXd free_space(const MatrixXd& jacobian) {
  const Eigen::JacobiSVD<MatrixXd> svd(jacobian, Eigen::ComputeFullV);
  const VectorXd& values = svd.singularValues();
  Eigen::Index rank = 0;
  while (rank < values.size() && values(rank) > kRank * values(0)) ++rank;
  return svd.matrixV().rightCols(jacobian.cols() - rank);
}

}  // namespace

std::vector<double> least_misses(const ResponseSystem& system, std::vector<double> start) {
  VectorXd x = vector_of(start);
  double damping = 1e-3;
  Linear linear = linearised(system, x);
  for (int step = 0; step < kMostSteps && x.norm() < kLostAt; ++step) {
    const MatrixXd normal = linear.jacobian.transpose() * linear.jacobian;
    const double scale = normal.diagonal().maxCoeff();
    if (!(scale > 0.0)) break;
    const MatrixXd damped = normal + damping * scale * MatrixXd::Identity(x.size(), x.size());
    const VectorXd move = -damped.ldlt().solve(linear.jacobian.transpose() * linear.misses);
    if (move.norm() < kSmallStep) break;
    if (misses_at(system, x + move).squaredNorm() < linear.misses.squaredNorm()) {
      x += move;
      linear = linearised(system, x);
      damping = std::max(1e-12, damping * 0.1);
    } else if ((damping *= 10.0) > 1e12) {
      break;
    }
  }
  return {x.begin(), x.end()};
}

std::size_t free_directions(const ResponseSystem& system, const std::vector<double>& x) {
  return static_cast<std::size_t>(free_space(linearised(system, vector_of(x)).jacobian).cols());
}

std::vector<double> nearest_on_curve(const ResponseSystem& system, std::vector<double> start) {
  VectorXd x = vector_of(start);
  for (int step = 0; step < kMostSteps; ++step) {
    const MatrixXd free = free_space(linearised(system, x).jacobian);
    // Half of the way along the curve towards the centre, then back onto it.
    const VectorXd along = x - 0.5 * (free * (free.transpose() * x));
    const std::vector<double> back = least_misses(system, {along.begin(), along.end()});
    const VectorXd next = vector_of(back);
    if (misses_at(system, next).cwiseAbs().maxCoeff() > kMet || next.norm() > x.norm() - kMet) break;
    x = next;
  }
  return {x.begin(), x.end()};
}

}  // namespace asperity
