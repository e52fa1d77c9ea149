#include "core/confrontation/extension_refit.hpp"

#include <algorithm>
#include <cmath>

#include "core/confrontation/bounded_least_squares.hpp"
#include "core/confrontation/extension_runs.hpp"

namespace asperity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMostPoints = 6;             // between two differencings
constexpr int kMostDifferencings = 2;      // of the effects where the hypothesis stands
constexpr int kMostLastPoints = 3;         // on all meshes
constexpr double kLongestStep = 4.0;       // of a parameter at radius 1, in its own steps
constexpr double kLongestAmplitude = 0.6;  // of a mechanism at radius 1, over its declared strong one
constexpr double kAnyRadius = 1e6, kMostRadius = 2.0, kLeastRadius = 0.05;
constexpr double kPoorShare = 0.25, kGoodShare = 0.7;  // of the promised gain that runs show
constexpr double kSmallGain = 1.0;                     // of the misfit, that another point is not run for
constexpr double kNear = 15.0;                         // of the best misfit: worth all meshes
constexpr double kRidge = 0.04;                        // holds what moves the data by less than 0.2 deviations
constexpr double kParameterDifference = 1.5;           // steps
constexpr double kAmplitudeDifference = 0.2;

/// What the refits of one confrontation share.
struct Refit {
  const ConfrontationTask& task;
  const Confrontation& state;
  WhitenedFrame frame;

  double misfit(const Hypothesis& h) const { return frame.whiten(h.difference).squaredNorm(); }
};

const Candidate& candidate_of(const Evidence& evidence, const Hypothesis& h, Index cause) {
  return evidence.candidates[static_cast<std::size_t>(h.causes[static_cast<std::size_t>(cause)])];
}

/// From where the hypothesis was run: parameters, then amplitudes.
struct Step {
  VectorXd coded, amplitude;

  double square() const { return coded.squaredNorm() + amplitude.squaredNorm(); }

  /// Over the longest steps.
  double size() const {
    const double parameters = coded.size() > 0 ? coded.cwiseAbs().maxCoeff() / kLongestStep : 0.0;
    return std::max(parameters, amplitude.cwiseAbs().maxCoeff() / kLongestAmplitude);
  }
};

Step step_between(const Hypothesis& from, const Hypothesis& to) {
  return {to.coded - from.coded, to.amplitude - from.amplitude};
}

VectorXd linear_difference(const Hypothesis& h, const Step& step) {
  return h.difference - h.jacobian * step.coded - h.directions * step.amplitude;
}

void keep_within(const Evidence& evidence, Hypothesis& h) {
  const ExtensionPoint point = point_of_run(evidence, {h.causes, h.coded, h.amplitude});
  h.coded = point.coded;
  h.amplitude = point.amplitude;
}

/// How far parameters and amplitudes may go: to the ends of their ranges, no farther than `radius` times the longest
/// steps. What takes whole numbers goes all the way.
struct Reach {
  VectorXd least, greatest;
};

Reach reach_of(const Evidence& evidence, const Hypothesis& from, double radius) {
  const Index parameters = from.coded.size(), causes = from.amplitude.size();
  Reach reach{VectorXd(parameters + causes), VectorXd(parameters + causes)};
  for (Index p = 0; p < parameters; ++p) {
    const CalibratedParameter& parameter = evidence.parameters[static_cast<std::size_t>(p)];
    reach.least(p) = std::clamp(parameter.lower - from.coded(p), -radius * kLongestStep, 0.0);
    reach.greatest(p) = std::clamp(parameter.upper - from.coded(p), 0.0, radius * kLongestStep);
  }
  for (Index i = 0; i < causes; ++i) {
    const Candidate& c = candidate_of(evidence, from, i);
    const double farthest = c.whole ? c.most : radius * kLongestAmplitude, at = from.amplitude(i);
    reach.least(parameters + i) = std::clamp((c.two_sided ? -c.most : 0.0) - at, -farthest, 0.0);
    reach.greatest(parameters + i) = std::clamp(c.most - at, 0.0, farthest);
  }
  return reach;
}

/// Where the linear fit about `from` wants to be, and the difference it promises there.
Hypothesis wanted(const Refit& refit, const Hypothesis& from, double radius) {
  const Evidence& evidence = refit.state.evidence;
  MatrixXd effects(from.difference.size(), from.jacobian.cols() + from.directions.cols());
  effects << from.jacobian, from.directions;
  const Reach reach = reach_of(evidence, from, radius);
  const VectorXd x = bounded_least_squares(refit.frame.whiten(effects), refit.frame.whiten(from.difference),
                                           reach.least, reach.greatest, kRidge);
  Hypothesis to = from;
  to.coded += x.head(from.coded.size());
  to.amplitude += x.tail(from.amplitude.size());
  keep_within(evidence, to);
  to.difference = linear_difference(from, step_between(from, to));
  return to;
}

/// Runs the hypothesis where it stands: its difference becomes theirs where they tell one. False where none does: it is
/// unchanged then, and only a promise.
bool run_there(const Refit& refit, std::size_t meshes, Hypothesis& h) {
  const Comparison& fitted = refit.state.fitted;
  const VectorXd less_model = fitted.data - fitted.model;
  RunChange change = change_by_runs(refit.task, refit.state, fitted, {h.causes, h.coded, h.amplitude}, meshes,
                                    extension_stage(refit.state.evidence, h.causes), less_model - h.difference);
  if (!change.told) return false;
  h.difference = less_model - change.mean;
  h.run_rows = std::move(change.rows);
  return true;
}

/// Broyden's update: the effects along the step are what two runs showed.
void learn(Hypothesis& h, const Step& step, const VectorXd& difference) {
  const VectorXd missed = linear_difference(h, step) - difference;
  h.jacobian += missed * step.coded.transpose() / step.square();
  h.directions += missed * step.amplitude.transpose() / step.square();
}

/// Gauss-Newton within a trust region: a point counts only if its own runs fit better, and what any point's runs show
/// corrects the effects.
void descend(const Refit& refit, std::size_t meshes, int most_points, Hypothesis& best) {
  double radius = 1.0;
  best.converged = false;
  for (int i = 0; i <= most_points && radius >= kLeastRadius; ++i) {
    best.converged = refit.misfit(best) - refit.misfit(wanted(refit, best, kAnyRadius)) < kSmallGain;
    Hypothesis tried = wanted(refit, best, radius);
    const Step step = step_between(best, tried);
    const double promised = refit.misfit(best) - refit.misfit(tried);
    if (best.converged || i == most_points || promised < kSmallGain) return;
    if (!run_there(refit, meshes, tried)) {
      radius = 0.5 * std::min(radius, step.size());
      continue;
    }
    const double share = (refit.misfit(best) - refit.misfit(tried)) / promised;
    learn(best, step, tried.difference);
    if (share < kPoorShare) radius = 0.5 * std::min(radius, step.size());
    if (share > kGoodShare) radius = std::min(kMostRadius, 2.0 * radius);
    if (share <= 0.0) continue;
    tried.jacobian = best.jacobian;
    tried.directions = best.directions;
    best = std::move(tried);
  }
}

/// To the side on which there is more room.
double difference_step(double least, double greatest, double step) {
  return greatest >= -least ? std::min(step, greatest) : std::max(-step, least);
}

/// Effects by finite differences where the hypothesis stands, on the meshes of a first look.
void difference_effects(const Refit& refit, Hypothesis& h) {
  constexpr double kNoRoom = 1e-3;
  const std::size_t meshes = refit.task.screen;
  const Reach reach = reach_of(refit.state.evidence, h, kAnyRadius);
  Hypothesis there = h;
  if (!run_there(refit, meshes, there)) return;
  const VectorXd& here = there.difference;
  const auto effect = [&](Index i, double step, double& coordinate, Hypothesis& moved, const VectorXd& before) {
    const double by = difference_step(reach.least(i), reach.greatest(i), step);
    const double from = coordinate;
    coordinate += by;
    keep_within(refit.state.evidence, moved);
    if (std::abs(coordinate - from) < kNoRoom) return before;
    moved.difference = here - before * (coordinate - from);
    if (!run_there(refit, meshes, moved)) return before;
    return VectorXd((here - moved.difference) / (coordinate - from));
  };
  for (Index p = 0; p < h.coded.size(); ++p) {
    Hypothesis moved = h;
    h.jacobian.col(p) = effect(p, kParameterDifference, moved.coded(p), moved, h.jacobian.col(p));
  }
  for (Index i = 0; i < h.amplitude.size(); ++i) {
    if (candidate_of(refit.state.evidence, h, i).whole) continue;
    Hypothesis moved = h;
    h.directions.col(i) =
        effect(h.coded.size() + i, kAmplitudeDifference, moved.amplitude(i), moved, h.directions.col(i));
  }
}

/// From the base's effects downhill; then with effects of its own as long as these find a better point.
Hypothesis refitted_by_runs(const Refit& refit, const std::vector<Index>& causes) {
  Hypothesis h = linear_hypothesis(refit.state.fitted, refit.state.base, causes);
  h.by_runs = true;
  descend(refit, refit.task.common, kMostPoints, h);
  for (int i = 0; i < kMostDifferencings; ++i) {
    const Hypothesis before = h;
    difference_effects(refit, h);
    descend(refit, refit.task.common, kMostPoints, h);
    if (step_between(before, h).size() <= 0.0) break;
  }
  return h;
}

/// A parameter at an end of what is believed absorbs nothing more.
void hold_ends(const std::vector<CalibratedParameter>& parameters, Hypothesis& h) {
  constexpr double kRounding = 1e-9;
  for (Index p = 0; p < h.coded.size(); ++p) {
    const CalibratedParameter& parameter = parameters[static_cast<std::size_t>(p)];
    if (h.coded(p) <= parameter.lower + kRounding || h.coded(p) >= parameter.upper - kRounding)
      h.jacobian.col(p).setZero();
  }
}

}  // namespace

std::vector<Hypothesis> hypotheses_by_runs(const ConfrontationTask& task, const Confrontation& state,
                                           const std::vector<std::vector<Index>>& lists) {
  const MatrixXd& covariance = state.scatter.covariance;
  const std::size_t all_meshes = task.plan.apart + task.plan.noise;
  const Refit refit{task, state, WhitenedFrame(covariance, MatrixXd(covariance.rows(), 0))};
  std::vector<Hypothesis> hypotheses;
  double best = refit.misfit(linear_hypothesis(state.fitted, state.base, {}));
  for (const std::vector<Index>& causes : lists) {
    hypotheses.push_back(refitted_by_runs(refit, causes));
    best = std::min(best, refit.misfit(hypotheses.back()));
  }
  for (Hypothesis& h : hypotheses) {
    if (refit.misfit(h) < best + kNear) {
      run_there(refit, all_meshes, h);
      descend(refit, all_meshes, kMostLastPoints, h);
    }
    hold_ends(state.evidence.parameters, h);
  }
  return hypotheses;
}

}  // namespace asperity
