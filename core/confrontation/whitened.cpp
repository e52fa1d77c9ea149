#include "core/confrontation/whitened.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.hpp"

namespace asperity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kLeastEffect = 0.2;  // standard deviations by which a step must move the data
constexpr int kMostSteps = 20;
constexpr double kSmallStep = 1e-9;

using Decomposition = Eigen::JacobiSVD<MatrixXd>;

/// With directions whose unit moves the data by less than kLeastEffect left out.
Decomposition decompose(const MatrixXd& whitened) {
  Decomposition svd(whitened, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const double largest = svd.singularValues().size() > 0 ? svd.singularValues()(0) : 0.0;
  svd.setThreshold(largest > kLeastEffect ? kLeastEffect / largest : 1.0);
  return svd;
}

/// Least squares for the parameters that are free.
VectorXd solved_step(const MatrixXd& jacobian, const VectorXd& residual, const std::vector<bool>& free) {
  std::vector<Index> columns;
  for (std::size_t p = 0; p < free.size(); ++p) {
    if (free[p]) columns.push_back(static_cast<Index>(p));
  }
  VectorXd step = VectorXd::Zero(jacobian.cols());
  if (columns.empty()) return step;
  MatrixXd part(jacobian.rows(), static_cast<Index>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i) part.col(static_cast<Index>(i)) = jacobian.col(columns[i]);
  const VectorXd solution = decompose(part).solve(residual);
  for (std::size_t i = 0; i < columns.size(); ++i) step(columns[i]) = solution(static_cast<Index>(i));
  return step;
}

MatrixXd jacobian_at(const Comparison& comparison, const VectorXd& coded) {
  return comparison.jacobian + comparison.curvature * coded.asDiagonal();
}

/// Moves until nothing changes; a parameter that would leave its range is held at its end.
void descend(const Comparison& comparison, const WhitenedFrame& frame,
             const std::vector<CalibratedParameter>& parameters, BaseFit& fit) {
  std::vector<bool> free = fit.determined;
  for (int i = 0; i < kMostSteps; ++i) {
    const MatrixXd jacobian = frame.whiten(jacobian_at(comparison, fit.coded));
    const VectorXd residual = frame.whiten(comparison.data - model_at(comparison, fit.coded));
    const VectorXd step = solved_step(jacobian, residual, free);
    bool held = false;
    for (Index p = 0; p < step.size(); ++p) {
      const CalibratedParameter& parameter = parameters[static_cast<std::size_t>(p)];
      const double wanted = fit.coded(p) + step(p);
      fit.coded(p) = std::clamp(wanted, parameter.lower, parameter.upper);
      if (wanted == fit.coded(p)) continue;
      free[static_cast<std::size_t>(p)] = false;
      fit.limited[static_cast<std::size_t>(p)] = held = true;
    }
    if (!held && step.norm() < kSmallStep) return;
  }
}

AmplitudeFit fit_one(const VectorXd& residual, const VectorXd& column, double least, double greatest) {
  const double square = column.squaredNorm();
  const double amplitude = std::clamp(square > 0.0 ? column.dot(residual) / square : 0.0, least, greatest);
  return {VectorXd::Constant(1, amplitude), (residual - amplitude * column).squaredNorm()};
}

}  // namespace

WhitenedFrame::WhitenedFrame(const MatrixXd& covariance, const MatrixXd& nuisance) {
  const Eigen::LLT<MatrixXd> factor(covariance);
  if (factor.info() != Eigen::Success) {
    throw Error(ErrorKind::numerical, {{"confrontation", "has a covariance that is not positive definite", "",
                                        "features that scatter", "a feature may be the same in every run"}});
  }
  lower_ = factor.matrixL();
  nuisance_.resize(covariance.rows(), 0);
  if (nuisance.cols() == 0) return;
  const Decomposition svd = decompose(whiten(nuisance));
  nuisance_ = svd.matrixU().leftCols(svd.singularValues()(0) > kLeastEffect ? svd.rank() : 0);
}

MatrixXd WhitenedFrame::whiten(const MatrixXd& columns) const {
  return lower_.triangularView<Eigen::Lower>().solve(columns);
}

MatrixXd WhitenedFrame::project(const MatrixXd& columns) const {
  const MatrixXd whitened = whiten(columns);
  return whitened - nuisance_ * (nuisance_.transpose() * whitened);
}

VectorXd WhitenedFrame::unwhiten(const VectorXd& standard) const {
  return lower_.triangularView<Eigen::Lower>() * standard;
}

VectorXd WhitenedFrame::solve(const MatrixXd& columns, const VectorXd& difference) const {
  if (columns.cols() == 0) return VectorXd(0);
  return decompose(whiten(columns)).solve(whiten(difference));
}

MatrixXd WhitenedFrame::information_inverse(const MatrixXd& columns) const {
  const Index count = columns.cols();
  if (count == 0) return MatrixXd(0, 0);
  const Decomposition svd = decompose(whiten(columns));
  MatrixXd inverse = MatrixXd::Zero(count, count);
  for (Index i = 0; i < count && svd.singularValues()(i) > kLeastEffect; ++i)
    inverse += svd.matrixV().col(i) * svd.matrixV().col(i).transpose() / std::pow(svd.singularValues()(i), 2);
  return inverse;
}

BaseFit calibrate_base(const Comparison& comparison, const MatrixXd& covariance,
                       const std::vector<CalibratedParameter>& parameters) {
  const Index count = static_cast<Index>(parameters.size());
  const WhitenedFrame frame(covariance, MatrixXd(covariance.rows(), 0));
  BaseFit fit;
  fit.coded = fit.error = VectorXd::Zero(count);
  fit.limited.assign(parameters.size(), false);
  const MatrixXd effects = frame.whiten(comparison.jacobian);
  for (Index p = 0; p < count; ++p) fit.determined.push_back(effects.col(p).norm() > kLeastEffect);
  if (count > 0) descend(comparison, frame, parameters, fit);
  fit.jacobian = jacobian_at(comparison, fit.coded);
  fit.difference = comparison.data - model_at(comparison, fit.coded);
  fit.absorbing = fit.jacobian;
  for (Index p = 0; p < count; ++p) {
    if (fit.limited[static_cast<std::size_t>(p)]) fit.absorbing.col(p).setZero();
  }
  fit.covariance = frame.information_inverse(fit.absorbing);
  if (count > 0) fit.error = fit.covariance.diagonal().array().sqrt();
  return fit;
}

AmplitudeFit fit_amplitudes(const VectorXd& residual, const MatrixXd& columns, const VectorXd& least,
                            const VectorXd& greatest) {
  if (columns.cols() == 1) return fit_one(residual, columns.col(0), least(0), greatest(0));
  const VectorXd free = columns.colPivHouseholderQr().solve(residual);
  if ((free.array() >= least.array()).all() && (free.array() <= greatest.array()).all())
    return {free, (residual - columns * free).squaredNorm()};
  AmplitudeFit best{VectorXd(2), std::numeric_limits<double>::max()};
  for (const Index held : {0, 1}) {
    for (const double bound : {least(held), greatest(held)}) {
      const Index other = 1 - held;
      const AmplitudeFit one =
          fit_one(residual - bound * columns.col(held), columns.col(other), least(other), greatest(other));
      if (one.misfit >= best.misfit) continue;
      best.misfit = one.misfit;
      best.amplitude(held) = bound;
      best.amplitude(other) = one.amplitude(0);
    }
  }
  return best;
}

}  // namespace asperity
