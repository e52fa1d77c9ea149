#include "core/confrontation/extension_runs.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMostRefits = 6;
constexpr double kLongestStep = 4.0;       // of a parameter, in its own steps
constexpr double kLongestAmplitude = 0.6;  // of a mechanism, over its declared strong one
constexpr double kSmallGain = 1.0;         // of the misfit, that another point is not run for

std::vector<MechanismAmplitude> mechanisms_of(const Evidence& evidence, const std::vector<Index>& causes,
                                              const VectorXd& amplitude) {
  std::vector<MechanismAmplitude> mechanisms;
  for (std::size_t i = 0; i < causes.size(); ++i) {
    const Candidate& candidate = evidence.candidates[static_cast<std::size_t>(causes[i])];
    const double a = amplitude_of_run(candidate, amplitude(static_cast<Index>(i)));
    if (a != 0.0) mechanisms.push_back({candidate.id, a});
  }
  return mechanisms;
}

/// Those of the mechanisms that act in this test.
std::vector<MechanismAmplitude> acting(const ConfrontationTask& task, const Evidence& evidence, std::size_t test,
                                       const std::vector<MechanismAmplitude>& mechanisms) {
  std::vector<MechanismAmplitude> kept;
  for (const MechanismAmplitude& m : mechanisms) {
    for (std::size_t k = 0; k < evidence.candidates.size(); ++k) {
      if (evidence.candidates[k].id == m.id && task.plan.candidate_acts[test][k]) kept.push_back(m);
    }
  }
  return kept;
}

/// Mean over meshes of the change against the base, slot by slot of the comparison; `otherwise` where it is not known.
VectorXd mean_change(const ConfrontationTask& task, const Confrontation& state, const Comparison& comparison,
                     const VectorXd& coded, const std::vector<MechanismAmplitude>& mechanisms, const std::string& stage,
                     const VectorXd& otherwise) {
  VectorXd change = otherwise;
  for (const ComparedTest& part : comparison.tests) {
    const auto t = static_cast<std::size_t>(part.test - state.evidence.tests.data());
    std::vector<VirtualSpecimen> specimens;
    const Index meshes = std::min<Index>(static_cast<Index>(task.common), part.test->base.rows());
    for (Index row = 0; row < meshes; ++row) {
      specimens.push_back({t, state.centre + coded, acting(task, state.evidence, t, mechanisms),
                           mesh_seed(task.plan, *part.test, static_cast<std::size_t>(row))});
    }
    const Samples runs = simulate_specimens(*part.test, specimens, stage, task.configure, task.features);
    for (std::size_t i = 0; i < part.columns.size(); ++i) {
      const VectorXd difference = runs.col(part.columns[i]) - part.test->base.col(part.columns[i]).head(meshes);
      double sum = 0.0, count = 0.0;
      for (const double d : difference) {
        if (!std::isfinite(d)) continue;
        sum += d;
        count += 1.0;
      }
      if (count >= 2.0) change(part.first + static_cast<Index>(i)) = sum / count;
    }
  }
  return change;
}

std::string stage_name(const Evidence& evidence, const std::vector<Index>& causes) {
  std::string name = "extension";
  for (const Index c : causes) name += " " + evidence.candidates[static_cast<std::size_t>(c)].id;
  return name;
}

void keep_within(const Evidence& evidence, const std::vector<Index>& causes, VectorXd& coded, VectorXd& amplitude) {
  for (Index p = 0; p < coded.size(); ++p) {
    const CalibratedParameter& parameter = evidence.parameters[static_cast<std::size_t>(p)];
    coded(p) = std::clamp(coded(p), parameter.lower, parameter.upper);
  }
  for (std::size_t i = 0; i < causes.size(); ++i) {
    double& a = amplitude(static_cast<Index>(i));
    a = amplitude_of_run(evidence.candidates[static_cast<std::size_t>(causes[i])], a);
  }
}

/// Towards the linear fit, no farther than effects may still hold; what takes whole numbers goes all the way.
void step_towards(const HypothesisFit& fit, const Evidence& evidence, Hypothesis& h) {
  const VectorXd coded = fit.coded - h.coded, amplitude = fit.amplitude - h.amplitude;
  const auto whole = [&](Index i) {
    return evidence.candidates[static_cast<std::size_t>(h.causes[static_cast<std::size_t>(i)])].whole;
  };
  double share = 1.0;
  if (coded.size() > 0) share = std::min(share, kLongestStep / std::max(coded.cwiseAbs().maxCoeff(), kLongestStep));
  for (Index i = 0; i < amplitude.size(); ++i) {
    if (!whole(i)) share = std::min(share, kLongestAmplitude / std::max(std::abs(amplitude(i)), kLongestAmplitude));
  }
  h.coded += share * coded;
  for (Index i = 0; i < amplitude.size(); ++i) h.amplitude(i) += (whole(i) ? 1.0 : share) * amplitude(i);
  keep_within(evidence, h.causes, h.coded, h.amplitude);
}

/// Broyden's update: the effects along the step are what two runs showed.
void learn(Hypothesis& h, const VectorXd& coded, const VectorXd& amplitude, const VectorXd& change) {
  const double square = coded.squaredNorm() + amplitude.squaredNorm();
  if (square <= 0.0) return;
  const VectorXd missed = change - h.jacobian * coded - h.directions * amplitude;
  h.jacobian += missed * coded.transpose() / square;
  h.directions += missed * amplitude.transpose() / square;
}

/// Runs the extension where the hypothesis stands and takes the difference there.
void run_there(const ConfrontationTask& task, const Confrontation& state, const VectorXd& otherwise, Hypothesis& h) {
  const std::vector<MechanismAmplitude> mechanisms = mechanisms_of(state.evidence, h.causes, h.amplitude);
  const VectorXd change =
      mean_change(task, state, state.fitted, h.coded, mechanisms, stage_name(state.evidence, h.causes), otherwise);
  h.difference = state.fitted.data - state.fitted.model - change;
}

/// Gauss-Newton with Broyden's effects: every point is run, the best one stands.
Hypothesis refitted_by_runs(const ConfrontationTask& task, const Confrontation& state,
                            const std::vector<Index>& causes) {
  const MatrixXd& covariance = state.scatter.covariance;
  const WhitenedFrame whole(covariance, MatrixXd(covariance.rows(), 0));
  const auto misfit = [&](const Hypothesis& h) { return whole.whiten(h.difference).squaredNorm(); };
  Hypothesis h = linear_hypothesis(state.fitted, state.base, causes);
  Hypothesis best = h;
  for (int i = 0; i < kMostRefits; ++i) {
    const Hypothesis before = h;
    const HypothesisFit fit = fit_hypothesis(covariance, state.evidence.candidates, h);
    step_towards(fit, state.evidence, h);
    const VectorXd coded = h.coded - before.coded, amplitude = h.amplitude - before.amplitude;
    const VectorXd reached = state.fitted.data - state.fitted.model - before.difference;
    run_there(task, state, reached + h.jacobian * coded + h.directions * amplitude, h);
    learn(h, coded, amplitude, before.difference - h.difference);
    if (i == 0 || misfit(h) < misfit(best)) best = h;
    best.converged = misfit(best) - fit_hypothesis(covariance, state.evidence.candidates, best).misfit < kSmallGain;
    if (best.converged) break;
  }
  return best;
}

}  // namespace

std::vector<Hypothesis> hypotheses_by_runs(const ConfrontationTask& task, const Confrontation& state,
                                           const std::vector<std::vector<Index>>& lists) {
  std::vector<Hypothesis> hypotheses;
  for (const std::vector<Index>& causes : lists) {
    hypotheses.push_back(held_within(refitted_by_runs(task, state, causes), state.evidence.parameters,
                                     state.scatter.covariance, state.evidence.candidates));
  }
  return hypotheses;
}

VectorXd extension_mean(const ConfrontationTask& task, const Confrontation& state, const HypothesisFit& fit) {
  VectorXd coded = fit.coded, amplitude = fit.amplitude;
  keep_within(state.evidence, fit.causes, coded, amplitude);
  const Comparison& kept_back = state.kept_back;
  const VectorXd linear = predict_extension(kept_back, state.kept_back_scatter, fit).mean - kept_back.model;
  return kept_back.model + mean_change(task, state, kept_back, coded,
                                       mechanisms_of(state.evidence, fit.causes, amplitude),
                                       stage_name(state.evidence, fit.causes) + " on kept-back tests", linear);
}

}  // namespace asperity
