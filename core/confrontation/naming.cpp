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

/// Noise of one repetition with the errors of the parameters' and the causes' effects; of a hypothesis by runs with
/// that of its own runs.
struct DrawnNoise {
  VectorXd error;
  MatrixXd covariance;
};

DrawnNoise drawn_noise(const Comparison& comparison, const Scatter& scatter, const BaseFit& base,
                       const Hypothesis& hypothesis, const HypothesisFit& fit, const NoiseOptions& options,
                       RandomStream& random) {
  Repetition again = repeat(comparison, scatter, options, random);
  VectorXd error = again.difference + drawn_parameter_error(comparison, base, random);
  if (hypothesis.by_runs) error += drawn_error(comparison, hypothesis.run_rows, random);
  for (std::size_t i = 0; i < fit.causes.size() && !hypothesis.by_runs; ++i) {
    const MatrixXd rows = effect_rows(comparison, fit.causes[i], fit.amplitude(static_cast<Index>(i)));
    error += drawn_error(comparison, rows, random);
  }
  for (Index i = 0; i < hypothesis.bend.size(); ++i) error(i) += hypothesis.bend(i) * random.normal();
  return {std::move(error), std::move(again.covariance)};
}

std::string stream_name(const std::vector<Index>& causes, const std::vector<Candidate>& candidates) {
  std::string name = "confrontation";
  for (const Index c : causes) name += " " + candidates[static_cast<std::size_t>(c)].id;
  return name;
}

/// Draws under hypothesis `k`: how well it then fits, and how far behind the best of all it then lies, Eq. (N23).
void judge_one(const Comparison& comparison, const Scatter& scatter, const BaseFit& base,
               const std::vector<Candidate>& candidates, const std::vector<Hypothesis>& hypotheses,
               const NamingOptions& options, std::size_t k, HypothesisFit& fit) {
  RandomStream random(options.draws.seed, stream_name(fit.causes, candidates));
  std::vector<double> misfits, excesses;
  for (int d = 0; d < options.draws.draws; ++d) {
    options.draws.at_each_draw();
    const DrawnNoise noise = drawn_noise(comparison, scatter, base, hypotheses[k], fit, options.draws.noise, random);
    double own = 0.0, best = std::numeric_limits<double>::max();
    for (std::size_t j = 0; j < hypotheses.size(); ++j) {
      const Hypothesis& h = hypotheses[j];
      const VectorXd difference = h.difference - fit.residual + noise.error;
      const WhitenedFrame frame(bent_covariance(noise.covariance, h), h.jacobian);
      const double misfit = refit(frame, difference, h, candidates).misfit;
      const double deviance = misfit + frame.log_determinant();
      best = std::min(best, deviance);
      if (j != k) continue;
      misfits.push_back(misfit);
      own = deviance;
    }
    excesses.push_back(own - best);
  }
  fit.p_misfit = share_above(misfits, fit.misfit);
  fit.p_excess = share_above(excesses, fit.excess);
  fit.kept = fit.p_misfit >= options.level && fit.p_excess >= options.level;
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

std::vector<HypothesisFit> judge(const Comparison& comparison, const Scatter& scatter, const BaseFit& fit,
                                 const std::vector<Candidate>& candidates, const std::vector<Hypothesis>& hypotheses,
                                 const NamingOptions& options) {
  std::vector<HypothesisFit> fits;
  double best = std::numeric_limits<double>::max();
  for (const Hypothesis& h : hypotheses) {
    fits.push_back(fit_hypothesis(scatter.covariance, candidates, h));
    best = std::min(best, fits.back().misfit + fits.back().widening);
  }
  for (std::size_t k = 0; k < fits.size(); ++k) {
    fits[k].excess = fits[k].misfit + fits[k].widening - best;
    judge_one(comparison, scatter, fit, candidates, hypotheses, options, k, fits[k]);
  }
  return fits;
}

SecondCause second_cause(const Comparison& comparison, const Scatter& scatter, const BaseFit& base,
                         const std::vector<Candidate>& candidates, const Hypothesis& first,
                         const NamingOptions& options) {
  const HypothesisFit fit = fit_hypothesis(scatter.covariance, candidates, first);
  const VectorXd step = fit.amplitude - first.amplitude;
  const MatrixXd slopes = slopes_at(first, step);
  MatrixXd nuisance(slopes.rows(), first.jacobian.cols() + slopes.cols());
  nuisance << first.jacobian, slopes;
  SecondCause second = strongest(comparison, WhitenedFrame(bent_covariance(scatter.covariance, first), nuisance),
                                 first.difference - change_of(first, step), candidates, first);
  if (second.candidate < 0) return second;
  RandomStream random(options.draws.seed, stream_name(first.causes, candidates) + " second");
  std::vector<double> explained;
  for (int d = 0; d < options.draws.draws; ++d) {
    options.draws.at_each_draw();
    const DrawnNoise noise = drawn_noise(comparison, scatter, base, first, fit, options.draws.noise, random);
    const WhitenedFrame frame(bent_covariance(noise.covariance, first), nuisance);
    explained.push_back(strongest(comparison, frame, noise.error, candidates, first).explained);
  }
  second.p = share_above(explained, second.explained);
  return second;
}

double cosine(const VectorXd& a, const VectorXd& b) {
  const double size = a.norm() * b.norm();
  return size > 0.0 ? a.dot(b) / size : 0.0;
}

}  // namespace asperity
