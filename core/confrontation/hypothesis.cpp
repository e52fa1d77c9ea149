#include "core/confrontation/hypothesis.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// How far each amplitude may still go from where the hypothesis was run.
struct AmplitudeRange {
  VectorXd least, greatest;
};

AmplitudeRange range_of(const std::vector<Candidate>& candidates, const Hypothesis& h) {
  AmplitudeRange range{-h.amplitude, -h.amplitude};
  for (Index i = 0; i < h.amplitude.size(); ++i) {
    const Candidate& c = candidates[static_cast<std::size_t>(h.causes[static_cast<std::size_t>(i)])];
    if (c.two_sided) range.least(i) -= c.most;
    range.greatest(i) += c.most;
  }
  return range;
}

/// The part of a cause's range with one slope: `offset` is what the slope's line has at amplitude 0.
struct Segment {
  VectorXd slope, offset;
  double least = 0, greatest = 0;
};

bool has_knee(const Hypothesis& h, Index i) { return i < h.knee.size() && std::isfinite(h.knee(i)); }

std::vector<Segment> segments_of(const Hypothesis& h, const AmplitudeRange& range, Index i) {
  const VectorXd none = VectorXd::Zero(h.directions.rows());
  if (!has_knee(h, i)) return {{h.directions.col(i), none, range.least(i), range.greatest(i)}};
  const double knee = h.knee(i);
  std::vector<Segment> segments;
  if (range.least(i) <= knee)
    segments.push_back({h.directions.col(i), none, range.least(i), std::min(knee, range.greatest(i))});
  if (range.greatest(i) > knee)
    segments.push_back({h.beyond.col(i), knee * (h.directions.col(i) - h.beyond.col(i)), std::max(knee, range.least(i)),
                        range.greatest(i)});
  return segments;
}

/// Every choice of one segment a cause.
std::vector<std::vector<Segment>> choices_of(const Hypothesis& h, const AmplitudeRange& range) {
  std::vector<std::vector<Segment>> choices{{}};
  for (Index i = 0; i < h.directions.cols(); ++i) {
    std::vector<std::vector<Segment>> longer;
    for (const std::vector<Segment>& choice : choices) {
      for (const Segment& segment : segments_of(h, range, i)) {
        longer.push_back(choice);
        longer.back().push_back(segment);
      }
    }
    choices = std::move(longer);
  }
  return choices;
}

AmplitudeFit fit_choice(const WhitenedFrame& frame, const VectorXd& difference, const std::vector<Segment>& choice) {
  const Index causes = static_cast<Index>(choice.size());
  VectorXd left = difference, least(causes), greatest(causes);
  MatrixXd slopes(difference.size(), causes);
  for (Index i = 0; i < causes; ++i) {
    const Segment& segment = choice[static_cast<std::size_t>(i)];
    left -= segment.offset;
    slopes.col(i) = segment.slope;
    least(i) = segment.least;
    greatest(i) = segment.greatest;
  }
  return fit_amplitudes(frame.project(left), frame.project(slopes), least, greatest);
}

MatrixXd beside(const MatrixXd& a, const MatrixXd& b) {
  MatrixXd both(a.rows(), a.cols() + b.cols());
  both << a, b;
  return both;
}

void move_to_linear_fit(const WhitenedFrame& frame, const AmplitudeFit& change, const Hypothesis& h,
                        HypothesisFit& fit) {
  fit.amplitude += change.amplitude;
  fit.misfit = change.misfit;
  const VectorXd left = h.difference - change_of(h, change.amplitude);
  fit.residual = frame.unwhiten(frame.project(left));
  fit.coded += frame.solve(h.jacobian, left);
}

}  // namespace

AmplitudeFit refit(const WhitenedFrame& frame, const VectorXd& difference, const Hypothesis& h,
                   const std::vector<Candidate>& candidates) {
  const AmplitudeRange range = range_of(candidates, h);
  AmplitudeFit best{VectorXd::Zero(h.directions.cols()), std::numeric_limits<double>::max()};
  for (const std::vector<Segment>& choice : choices_of(h, range)) {
    AmplitudeFit fit = fit_choice(frame, difference, choice);
    if (fit.misfit < best.misfit) best = std::move(fit);
  }
  return best;
}

VectorXd change_of(const Hypothesis& h, const VectorXd& step) {
  VectorXd change = VectorXd::Zero(h.difference.size());
  for (Index i = 0; i < step.size(); ++i) {
    const double near = has_knee(h, i) ? std::min(step(i), h.knee(i)) : step(i);
    change += near * h.directions.col(i);
    if (near != step(i)) change += (step(i) - near) * h.beyond.col(i);
  }
  return change;
}

MatrixXd slopes_at(const Hypothesis& h, const VectorXd& step) {
  MatrixXd slopes = h.directions;
  for (Index i = 0; i < step.size(); ++i) {
    if (has_knee(h, i) && step(i) > h.knee(i)) slopes.col(i) = h.beyond.col(i);
  }
  return slopes;
}

MatrixXd bent_covariance(const MatrixXd& covariance, const Hypothesis& h) {
  MatrixXd own = covariance;
  if (h.bend.size() > 0) own.diagonal() += h.bend.array().square().matrix();
  return own;
}

Hypothesis with_bend(Hypothesis h, const Comparison& comparison, const MatrixXd& covariance,
                     const std::vector<Candidate>& candidates) {
  const HypothesisFit fit = fit_hypothesis(covariance, candidates, h);
  VectorXd squares = VectorXd::Zero(h.difference.size());
  for (std::size_t i = 0; i < h.causes.size(); ++i)
    squares += bend_of(comparison, h.causes[i], fit.amplitude(static_cast<Index>(i))).array().square().matrix();
  h.bend = squares.array().sqrt();
  return h;
}

HypothesisFit fit_hypothesis(const MatrixXd& covariance, const std::vector<Candidate>& candidates,
                             const Hypothesis& h) {
  const MatrixXd own = bent_covariance(covariance, h);
  const WhitenedFrame frame(own, h.jacobian);
  HypothesisFit fit;
  fit.causes = h.causes;
  fit.converged = h.converged;
  fit.amplitude = h.amplitude;
  fit.coded = h.coded;
  fit.residual = h.difference;
  const MatrixXd no_nuisance(own.rows(), 0);
  fit.misfit = WhitenedFrame(own, no_nuisance).whiten(h.difference).squaredNorm();
  fit.widening = frame.log_determinant() - WhitenedFrame(covariance, no_nuisance).log_determinant();
  if (!h.by_runs) move_to_linear_fit(frame, refit(frame, h.difference, h, candidates), h, fit);
  fit.covariance = frame.information_inverse(beside(h.jacobian, slopes_at(h, fit.amplitude - h.amplitude)));
  fit.amplitude_error = fit.covariance.diagonal().tail(fit.amplitude.size()).array().sqrt();
  return fit;
}

Hypothesis held_within(Hypothesis h, const std::vector<CalibratedParameter>& parameters, const MatrixXd& covariance,
                       const std::vector<Candidate>& candidates) {
  constexpr double kRounding = 1e-9;
  for (std::size_t held = 0; held < parameters.size(); ++held) {
    const HypothesisFit fit = fit_hypothesis(covariance, candidates, h);
    Index worst = -1;
    double most = kRounding, bound = 0.0;
    for (Index p = 0; p < fit.coded.size(); ++p) {
      const CalibratedParameter& parameter = parameters[static_cast<std::size_t>(p)];
      const double within = std::clamp(fit.coded(p), parameter.lower, parameter.upper);
      if (std::abs(fit.coded(p) - within) <= most) continue;
      worst = p;
      most = std::abs(fit.coded(p) - within);
      bound = within;
    }
    if (worst < 0) break;
    h.difference -= h.jacobian.col(worst) * (bound - h.coded(worst));
    h.coded(worst) = bound;
    h.jacobian.col(worst).setZero();
  }
  return h;
}

Hypothesis linear_hypothesis(const Comparison& comparison, const BaseFit& fit, std::vector<Index> causes) {
  Hypothesis h;
  h.amplitude = VectorXd::Zero(static_cast<Index>(causes.size()));
  h.coded = fit.coded;
  h.difference = fit.difference;
  h.jacobian = fit.jacobian;
  h.directions = h.beyond = MatrixXd(comparison.data.size(), static_cast<Index>(causes.size()));
  for (std::size_t i = 0; i < causes.size(); ++i) {
    const Index k = causes[i], at = static_cast<Index>(i);
    h.directions.col(at) = slope_of(comparison, k, std::min(comparison.reach(k), 0.0));
    h.beyond.col(at) = slope_of(comparison, k, std::max(comparison.reach(k), comparison.first(k)));
  }
  h.knee = comparison.knee(causes);
  h.causes = std::move(causes);
  return h;
}

}  // namespace asperity
