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
constexpr double kNone = 2.0;         // times the largest singular value: no direction has an effect
constexpr int kMostSteps = 50;
constexpr double kSmallStep = 1e-9, kSmallSlope = 1e-6;

using Decomposition = Eigen::JacobiSVD<MatrixXd>;

/// With directions whose unit moves the data by less than kLeastEffect left out.
Decomposition decompose(const MatrixXd& whitened) {
  Decomposition svd(whitened, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const double largest = svd.singularValues().size() > 0 ? svd.singularValues()(0) : 0.0;
  svd.setThreshold(largest > kLeastEffect ? kLeastEffect / largest : kNone);
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

/// The held parameter that the misfit wants back inside its range most; -1: none.
Index wanted_back(const Comparison& comparison, const WhitenedFrame& frame,
                  const std::vector<CalibratedParameter>& parameters, const BaseFit& fit) {
  const MatrixXd jacobian = frame.whiten(jacobian_at(comparison, fit.coded));
  const VectorXd downhill = jacobian.transpose() * frame.whiten(comparison.data - model_at(comparison, fit.coded));
  Index back = -1;
  double most = kSmallSlope;
  for (Index p = 0; p < downhill.size(); ++p) {
    if (!fit.limited[static_cast<std::size_t>(p)]) continue;
    const double inwards = fit.coded(p) >= parameters[static_cast<std::size_t>(p)].upper ? -downhill(p) : downhill(p);
    if (inwards <= most) continue;
    back = p;
    most = inwards;
  }
  return back;
}

/// How far a step may go until the first free parameter reaches an end of its range, as a share; which one, or -1.
struct FirstEnd {
  double share = 1.0;
  Index parameter = -1;
  double end = 0;
};

FirstEnd first_end(const VectorXd& coded, const VectorXd& step, const std::vector<CalibratedParameter>& parameters) {
  FirstEnd first;
  for (Index p = 0; p < step.size(); ++p) {
    const CalibratedParameter& parameter = parameters[static_cast<std::size_t>(p)];
    const double end = step(p) > 0.0 ? parameter.upper : parameter.lower;
    if (step(p) == 0.0 || std::abs(end - coded(p)) >= first.share * std::abs(step(p))) continue;
    first = {std::abs(end - coded(p)) / std::abs(step(p)), p, end};
  }
  return first;
}

/// Gauss-Newton within the ranges, by an active set: a step ends where the first parameter reaches its end, which then
/// holds it; at the optimum of the others the one that the misfit wants back most is freed.
void descend(const Comparison& comparison, const WhitenedFrame& frame,
             const std::vector<CalibratedParameter>& parameters, BaseFit& fit) {
  std::vector<bool> free = fit.determined;
  for (int i = 0; i < kMostSteps; ++i) {
    const MatrixXd jacobian = frame.whiten(jacobian_at(comparison, fit.coded));
    const VectorXd residual = frame.whiten(comparison.data - model_at(comparison, fit.coded));
    const VectorXd step = solved_step(jacobian, residual, free);
    const FirstEnd first = first_end(fit.coded, step, parameters);
    fit.coded += first.share * step;
    if (first.parameter >= 0) {
      fit.coded(first.parameter) = first.end;
      free[static_cast<std::size_t>(first.parameter)] = false;
      fit.limited[static_cast<std::size_t>(first.parameter)] = true;
      continue;
    }
    if (step.norm() >= kSmallStep) continue;
    const Index back = wanted_back(comparison, frame, parameters, fit);
    if (back < 0) return;
    free[static_cast<std::size_t>(back)] = true;
    fit.limited[static_cast<std::size_t>(back)] = false;
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
  nuisance_ = svd.matrixU().leftCols(svd.rank());
}

double WhitenedFrame::log_determinant() const { return 2.0 * lower_.diagonal().array().log().sum(); }

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
  for (Index i = 0; i < svd.singularValues().size() && svd.singularValues()(i) > kLeastEffect; ++i)
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
