#include "core/confrontation/extension_runs.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

std::vector<MechanismAmplitude> mechanisms_of(const Evidence& evidence, const std::vector<Index>& causes,
                                              const VectorXd& amplitude) {
  std::vector<MechanismAmplitude> mechanisms;
  for (std::size_t i = 0; i < causes.size(); ++i) {
    const double a = amplitude(static_cast<Index>(i));
    if (a != 0.0) mechanisms.push_back({evidence.candidates[static_cast<std::size_t>(causes[i])].id, a});
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

}  // namespace

std::vector<Hypothesis> hypotheses_by_runs(const ConfrontationTask& task, const Confrontation& state,
                                           const std::vector<std::vector<Index>>& lists) {
  const WhitenedFrame frame(state.scatter.covariance, state.base.jacobian);
  std::vector<Hypothesis> hypotheses;
  for (const std::vector<Index>& causes : lists) {
    Hypothesis h = linear_hypothesis(state.fitted, state.base, causes);
    const HypothesisFit fit = fit_hypothesis(frame, state.base, state.evidence.candidates, h);
    h.amplitude = fit.amplitude;
    for (std::size_t i = 0; i < causes.size(); ++i) {
      const double most = state.evidence.candidates[static_cast<std::size_t>(causes[i])].most;
      h.amplitude(static_cast<Index>(i)) = std::clamp(h.amplitude(static_cast<Index>(i)), -most, most);
    }
    h.coded = fit.coded;
    for (Index p = 0; p < h.coded.size(); ++p) {
      const CalibratedParameter& parameter = state.evidence.parameters[static_cast<std::size_t>(p)];
      h.coded(p) = std::clamp(h.coded(p), parameter.lower, parameter.upper);
    }
    const VectorXd linear = model_at(state.fitted, h.coded) - state.fitted.model + h.directions * h.amplitude;
    const std::vector<MechanismAmplitude> mechanisms = mechanisms_of(state.evidence, causes, h.amplitude);
    h.difference =
        state.fitted.data - state.fitted.model -
        mean_change(task, state, state.fitted, h.coded, mechanisms, stage_name(state.evidence, causes), linear);
    hypotheses.push_back(std::move(h));
  }
  return hypotheses;
}

VectorXd extension_mean(const ConfrontationTask& task, const Confrontation& state, const HypothesisFit& fit) {
  VectorXd coded = fit.coded, amplitude = fit.amplitude;
  for (Index p = 0; p < coded.size(); ++p) {
    const CalibratedParameter& parameter = state.evidence.parameters[static_cast<std::size_t>(p)];
    coded(p) = std::clamp(coded(p), parameter.lower, parameter.upper);
  }
  for (std::size_t i = 0; i < fit.causes.size(); ++i) {
    const double most = state.evidence.candidates[static_cast<std::size_t>(fit.causes[i])].most;
    amplitude(static_cast<Index>(i)) = std::clamp(amplitude(static_cast<Index>(i)), -most, most);
  }
  const Comparison& kept_back = state.kept_back;
  const VectorXd linear = predict_extension(kept_back, state.kept_back_scatter, fit).mean - kept_back.model;
  return kept_back.model + mean_change(task, state, kept_back, coded,
                                       mechanisms_of(state.evidence, fit.causes, amplitude),
                                       stage_name(state.evidence, fit.causes) + " on kept-back tests", linear);
}

}  // namespace asperity
