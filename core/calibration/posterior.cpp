#include "core/calibration/posterior.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <openturns/SobolSequence.hxx>

namespace asperity {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMostSteps = 50;
constexpr double kSmallStep = 1e-6;  // coded: far below any scatter of a parameter
constexpr std::size_t kLooks = 128;  // points of the region whose cost is looked at ...
constexpr std::size_t kStarts = 4;   // ... and how many of them are started from: few modes, as over a quadratic

/// Whitened misses and their derivatives at theta, the prior's included: cost = |residual|^2.
struct Linear {
  VectorXd residual;
  MatrixXd jacobian;
};

VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// Within one step the emulator's own variance stands still.
Linear linearised(const PosteriorProblem& problem, const std::vector<double>& theta) {
  const auto m = static_cast<Eigen::Index>(problem.targets.size()), k = static_cast<Eigen::Index>(theta.size());
  Linear linear{VectorXd(m + k), MatrixXd::Zero(m + k, k)};
  for (Eigen::Index r = 0; r < m; ++r) {
    const auto target = static_cast<std::size_t>(r);
    const Emulator& emulator = problem.emulators[target];
    const double sd = std::sqrt(problem.noise[target] + emulator.variance(theta));
    linear.residual(r) = (emulator.mean(theta) - problem.targets[target].value) / sd;
    linear.jacobian.row(r) = vector_of(emulator.gradient(theta)).transpose() / sd;
  }
  linear.residual.tail(k) = vector_of(theta) / problem.prior_sd;
  linear.jacobian.bottomRows(k) = MatrixXd::Identity(k, k) / problem.prior_sd;
  return linear;
}

/// Eq. (S33) without its logarithm of the variances, which changes little over a design.
double cost_at(const PosteriorProblem& problem, const std::vector<double>& theta) {
  double cost = 0.0;
  for (std::size_t r = 0; r < problem.targets.size(); ++r) {
    const double miss = problem.emulators[r].mean(theta) - problem.targets[r].value;
    cost += miss * miss / (problem.noise[r] + problem.emulators[r].variance(theta));
  }
  for (double v : theta) cost += v * v / (problem.prior_sd * problem.prior_sd);
  return cost;
}

/// One step, halved until it lowers the cost; where none does, theta as it was.
std::vector<double> stepped(const PosteriorProblem& problem, const std::vector<double>& theta, double cost) {
  const Linear linear = linearised(problem, theta);
  const VectorXd step =
      -(linear.jacobian.transpose() * linear.jacobian).ldlt().solve(linear.jacobian.transpose() * linear.residual);
  for (double share = 1.0; share * step.norm() > kSmallStep; share *= 0.5) {
    const VectorXd next = vector_of(theta) + share * step;
    std::vector<double> drawn = drawn_in(problem.region, {next.begin(), next.end()});
    if (cost_at(problem, drawn) < cost) return drawn;
  }
  return theta;
}

Posterior descend(const PosteriorProblem& problem, std::vector<double> theta) {
  double cost = cost_at(problem, theta);
  for (int step = 0; step < kMostSteps; ++step) {
    std::vector<double> next = stepped(problem, theta, cost);
    if (next == theta) break;
    theta = std::move(next);
    cost = cost_at(problem, theta);
  }
  return {std::move(theta), {}, cost};
}

/// Eq. (S35).
std::vector<double> covariance_at(const PosteriorProblem& problem, const std::vector<double>& theta) {
  const Linear linear = linearised(problem, theta);
  const MatrixXd inverse = (linear.jacobian.transpose() * linear.jacobian).inverse();
  return {inverse.data(), inverse.data() + inverse.size()};
}

}  // namespace

Posterior find_mode(const PosteriorProblem& problem, const std::vector<double>& start) {
  std::vector<std::pair<double, std::vector<double>>> starts{{cost_at(problem, start), start}};
  const OT::Sample sobol = OT::SobolSequence(start.size()).generate(kLooks);
  for (std::size_t i = 0; i < sobol.getSize(); ++i) {
    std::vector<double> x(start.size());
    for (std::size_t j = 0; j < x.size(); ++j) x[j] = problem.region.alpha * (2.0 * sobol(i, j) - 1.0);
    x = drawn_in(problem.region, std::move(x));
    const double cost = cost_at(problem, x);
    starts.emplace_back(cost, std::move(x));
  }
  std::sort(starts.begin() + 1, starts.end());
  Posterior best = descend(problem, start);
  for (std::size_t i = 1; i <= kStarts; ++i) {
    Posterior other = descend(problem, starts[i].second);
    if (other.cost < best.cost) best = std::move(other);
  }
  best.covariance = covariance_at(problem, best.theta);
  return best;
}

}  // namespace asperity
