#include "core/confrontation/naming.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

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

AmplitudeFit refit(const WhitenedFrame& frame, const VectorXd& difference, const Hypothesis& h,
                   const AmplitudeRange& range) {
  AmplitudeFit best{VectorXd::Zero(h.directions.cols()), std::numeric_limits<double>::max()};
  for (const std::vector<Segment>& choice : choices_of(h, range)) {
    AmplitudeFit fit = fit_choice(frame, difference, choice);
    if (fit.misfit < best.misfit) best = std::move(fit);
  }
  return best;
}

/// What a step of the amplitudes changes, and the slopes where it ends.
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

MatrixXd beside(const MatrixXd& a, const MatrixXd& b) {
  MatrixXd both(a.rows(), a.cols() + b.cols());
  both << a, b;
  return both;
}

/// Noise of one repetition with the errors of the parameters' and the causes' effects.
struct DrawnNoise {
  VectorXd error;
  MatrixXd covariance;
};

DrawnNoise drawn_noise(const Comparison& comparison, const Scatter& scatter, const BaseFit& base,
                       const HypothesisFit& fit, const NoiseOptions& options, RandomStream& random) {
  Repetition again = repeat(comparison, scatter, options, random);
  VectorXd error = again.difference + drawn_parameter_error(comparison, base, random);
  for (std::size_t i = 0; i < fit.causes.size(); ++i) {
    const MatrixXd rows = effect_rows(comparison, fit.causes[i], fit.amplitude(static_cast<Index>(i)));
    error += drawn_error(comparison, rows, random);
  }
  return {std::move(error), std::move(again.covariance)};
}

std::string stream_name(const std::vector<Index>& causes, const std::vector<Candidate>& candidates) {
  std::string name = "confrontation";
  for (const Index c : causes) name += " " + candidates[static_cast<std::size_t>(c)].id;
  return name;
}

/// Draws under hypothesis `k`: how well it then fits, and how far behind the best of all it then lies.
void judge_one(const Comparison& comparison, const Scatter& scatter, const BaseFit& base,
               const std::vector<Candidate>& candidates, const std::vector<Hypothesis>& hypotheses,
               const NamingOptions& options, std::size_t k, HypothesisFit& fit) {
  RandomStream random(options.draws.seed, stream_name(fit.causes, candidates));
  std::vector<double> misfits, excesses;
  for (int d = 0; d < options.draws.draws; ++d) {
    const DrawnNoise noise = drawn_noise(comparison, scatter, base, fit, options.draws.noise, random);
    double own = 0.0, best = std::numeric_limits<double>::max();
    for (std::size_t j = 0; j < hypotheses.size(); ++j) {
      const Hypothesis& h = hypotheses[j];
      const VectorXd difference = h.difference - fit.residual + noise.error;
      const WhitenedFrame frame(noise.covariance, h.jacobian);
      const double misfit = refit(frame, difference, h, range_of(candidates, h)).misfit;
      best = std::min(best, misfit);
      if (j == k) own = misfit;
    }
    misfits.push_back(own);
    excesses.push_back(own - best);
  }
  fit.p_misfit = share_above(misfits, fit.misfit);
  fit.p_excess = share_above(excesses, fit.excess);
  fit.kept = fit.p_misfit >= options.level && fit.p_excess >= options.level;
}

void move_to_linear_fit(const WhitenedFrame& frame, const AmplitudeFit& change, const Hypothesis& h,
                        HypothesisFit& fit) {
  fit.amplitude += change.amplitude;
  fit.misfit = change.misfit;
  const VectorXd left = h.difference - change_of(h, change.amplitude);
  fit.residual = frame.unwhiten(frame.project(left));
  fit.coded += frame.solve(h.jacobian, left);
}

/// Largest part that any other candidate explains beyond the first.
SecondCause strongest(const Comparison& comparison, const WhitenedFrame& frame, const VectorXd& difference,
                      const std::vector<Candidate>& candidates, const Hypothesis& first) {
  const Pattern pattern = pattern_of(frame, difference, comparison, candidates);
  SecondCause second;
  for (Index k = 0; k < pattern.explained.size(); ++k) {
    if (std::find(first.causes.begin(), first.causes.end(), k) != first.causes.end()) continue;
    if (pattern.explained(k) <= second.explained) continue;
    second.candidate = k;
    second.explained = pattern.explained(k);
  }
  return second;
}

}  // namespace

HypothesisFit fit_hypothesis(const MatrixXd& covariance, const std::vector<Candidate>& candidates,
                             const Hypothesis& h) {
  const WhitenedFrame frame(covariance, h.jacobian);
  HypothesisFit fit;
  fit.causes = h.causes;
  fit.converged = h.converged;
  fit.amplitude = h.amplitude;
  fit.coded = h.coded;
  fit.residual = h.difference;
  fit.misfit = WhitenedFrame(covariance, MatrixXd(covariance.rows(), 0)).whiten(h.difference).squaredNorm();
  if (!h.by_runs) move_to_linear_fit(frame, refit(frame, h.difference, h, range_of(candidates, h)), h, fit);
  fit.covariance = frame.information_inverse(beside(h.jacobian, slopes_at(h, fit.amplitude - h.amplitude)));
  fit.amplitude_error = fit.covariance.diagonal().tail(fit.amplitude.size()).array().sqrt();
  return fit;
}

std::vector<Index> refit_candidates(const Gate& gate, const NamingOptions& options) {
  std::vector<Index> order(static_cast<std::size_t>(gate.pattern.explained.size()));
  std::iota(order.begin(), order.end(), Index{0});
  const VectorXd& explained = gate.pattern.explained;
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return explained(a) > explained(b); });
  const auto far = [&](Index k) {
    return explained(k) <= 0.0 || explained(k) < explained(order.front()) - options.near;
  };
  order.erase(std::find_if(order.begin(), order.end(), far), order.end());
  if (order.size() > options.most) order.resize(options.most);
  return order;
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
  h.directions = comparison.fingerprint(Eigen::all, causes);
  h.beyond = comparison.beyond(Eigen::all, causes);
  h.knee = comparison.knee(causes);
  h.causes = std::move(causes);
  return h;
}

std::vector<HypothesisFit> judge(const Comparison& comparison, const Scatter& scatter, const BaseFit& fit,
                                 const std::vector<Candidate>& candidates, const std::vector<Hypothesis>& hypotheses,
                                 const NamingOptions& options) {
  std::vector<HypothesisFit> fits;
  double best = std::numeric_limits<double>::max();
  for (const Hypothesis& h : hypotheses) {
    fits.push_back(fit_hypothesis(scatter.covariance, candidates, h));
    best = std::min(best, fits.back().misfit);
  }
  for (std::size_t k = 0; k < fits.size(); ++k) {
    fits[k].excess = fits[k].misfit - best;
    judge_one(comparison, scatter, fit, candidates, hypotheses, options, k, fits[k]);
  }
  return fits;
}

SecondCause second_cause(const Comparison& comparison, const Scatter& scatter, const BaseFit& base,
                         const std::vector<Candidate>& candidates, const Hypothesis& first,
                         const NamingOptions& options) {
  const HypothesisFit fit = fit_hypothesis(scatter.covariance, candidates, first);
  const VectorXd step = fit.amplitude - first.amplitude;
  const MatrixXd nuisance = beside(first.jacobian, slopes_at(first, step));
  SecondCause second = strongest(comparison, WhitenedFrame(scatter.covariance, nuisance),
                                 first.difference - change_of(first, step), candidates, first);
  if (second.candidate < 0) return second;
  RandomStream random(options.draws.seed, stream_name(first.causes, candidates) + " second");
  std::vector<double> explained;
  for (int d = 0; d < options.draws.draws; ++d) {
    const DrawnNoise noise = drawn_noise(comparison, scatter, base, fit, options.draws.noise, random);
    const WhitenedFrame frame(noise.covariance, nuisance);
    explained.push_back(strongest(comparison, frame, noise.error, candidates, first).explained);
  }
  second.p = share_above(explained, second.explained);
  return second;
}

double cosine(const WhitenedFrame& frame, const Comparison& comparison, Index a, Index b) {
  const VectorXd x = frame.project(comparison.fingerprint.col(a)), y = frame.project(comparison.fingerprint.col(b));
  const double size = x.norm() * y.norm();
  return size > 0.0 ? x.dot(y) / size : 0.0;
}

}  // namespace asperity
