#include "core/confrontation/confront.hpp"

#include <algorithm>
#include <limits>

#include "core/base/error.hpp"
#include "core/confrontation/extension_refit.hpp"
#include "core/confrontation/extension_runs.hpp"
#include "core/confrontation/short_runs.hpp"

namespace asperity {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kSmallMove = 0.25;    // steps of a parameter within which effects stand still
constexpr std::size_t kWorthMore = 8;  // candidates at least that get all meshes
constexpr std::size_t kDecoys = 2;

/// Parameters about a new centre.
void shift_limits(std::vector<CalibratedParameter>& parameters, const VectorXd& move) {
  for (Index p = 0; p < move.size(); ++p) {
    parameters[static_cast<std::size_t>(p)].lower -= move(p);
    parameters[static_cast<std::size_t>(p)].upper -= move(p);
  }
}

/// Without a compared feature there is nothing to say.
void require_features(const Comparison& fitted) {
  if (!fitted.slots.empty()) return;
  std::vector<Fault> faults{{"/measured", "no feature of a fitted test can be compared", "",
                             "a feature that measurement and runs both give", "see docs/confrontation.md"}};
  for (const DroppedSlot& slot : fitted.dropped)
    if (slot.why != "not measured") faults.push_back({slot.test + ", " + slot.feature, slot.why, "", "", ""});
  throw Error(ErrorKind::config, faults);
}

/// Twice, the second time with what is not known of effects on the way, Eq. (N20).
void calibrate(const Comparison& comparison, const std::vector<CalibratedParameter>& parameters,
               const NoiseOptions& options, Scatter& scatter, BaseFit& base) {
  scatter = scatter_of(comparison, options);
  base = calibrate_base(comparison, scatter.covariance, parameters);
  scatter = scatter_at(comparison, base.coded, options);
  base = calibrate_base(comparison, scatter.covariance, parameters);
}

void compare_fitted(Confrontation& state, const NamingOptions& options) {
  state.fitted = compare(state.evidence, TestUse::fit);
  require_features(state.fitted);
  calibrate(state.fitted, state.evidence.parameters, options.draws.noise, state.scatter, state.base);
}

/// On other meshes than effects: what chance makes of the base's runs on those is in every fingerprint, too.
Gate gate_apart(const Confrontation& state, const GateOptions& options) {
  const Comparison comparison = compare(state.evidence, TestUse::fit, BaseMean::apart);
  Scatter scatter;
  BaseFit base;
  calibrate(comparison, state.evidence.parameters, options.noise, scatter, base);
  return gate(comparison, scatter, base, state.evidence.candidates, options);
}

/// Gauss-Newton with real runs: the centre moves to the calibrated parameters.
void calibrate_by_runs(const ConfrontationTask& task, Confrontation& state) {
  EvidencePlan plan = task.plan;
  plan.noise = task.common;
  plan.fresh = 0;
  plan.apart = 0;
  plan.parameters = task.screen;
  std::fill(plan.candidate_meshes.begin(), plan.candidate_meshes.end(), 0);
  for (int step = 0; step < task.most_steps; ++step) {
    simulate_evidence(state.evidence, plan, state.centre, "calibration, step " + std::to_string(step + 1),
                      task.configure, task.features);
    compare_fitted(state, task.options);
    state.centre += state.base.coded;
    shift_limits(state.evidence.parameters, state.base.coded);
    if (state.base.coded.cwiseAbs().maxCoeff() < kSmallMove) return;
  }
}

/// After a screening on few meshes: the candidates that explain most get all of them.
std::vector<std::size_t> worthwhile_meshes(const ConfrontationTask& task, const Gate& gate) {
  NamingOptions options = task.options;
  options.most = kWorthMore;
  std::vector<std::size_t> meshes(task.evidence.candidates.size(), task.screen);
  for (const Index k : refit_candidates(gate, options)) meshes[static_cast<std::size_t>(k)] = task.common;
  return meshes;
}

void simulate_effects(const ConfrontationTask& task, Confrontation& state) {
  EvidencePlan plan = task.plan;
  plan.kept_back_candidates = task.linearised_at == LinearisedAt::reference;
  const bool screened = task.linearised_at == LinearisedAt::calibrated && task.screen < task.common;
  plan.candidate_meshes.assign(state.evidence.candidates.size(), screened ? task.screen : task.common);
  simulate_evidence(state.evidence, plan, state.centre, "effects", task.configure, task.features);
  compare_fitted(state, task.options);
  if (!screened) return;
  const WhitenedFrame frame(state.scatter.covariance, state.base.absorbing);
  Gate first;
  first.pattern = pattern_of(frame, state.base.difference, state.fitted, state.evidence.candidates);
  plan.candidate_meshes = worthwhile_meshes(task, first);
  simulate_evidence(state.evidence, plan, state.centre, "effects of likely causes", task.configure, task.features);
  compare_fitted(state, task.options);
}

ExtensionGain extension_gain(const ConfrontationTask& task, const Confrontation& state, const HypothesisFit& fit) {
  ExtensionGain extension{fit, std::nullopt};
  if (state.kept_back.data.size() == 0) return extension;
  const FeaturePrediction base = predict_base(state.kept_back, state.kept_back_scatter, state.base);
  const FeaturePrediction with = task.linearised_at == LinearisedAt::calibrated
                                     ? predict_by_runs(task, state, fit)
                                     : predict_extension(state.kept_back, state.kept_back_scatter, fit);
  extension.gain = measure_gain(state.kept_back, state.kept_back_scatter, base, with, task.options.draws);
  return extension;
}

bool among(const std::vector<HypothesisFit>& fits, Index cause) {
  return std::any_of(fits.begin(), fits.end(), [&](const HypothesisFit& fit) {
    return std::find(fit.causes.begin(), fit.causes.end(), cause) != fit.causes.end();
  });
}

/// The candidates that would have been the next to be believed, best first: refitted ones, then by what they explain.
std::vector<Index> decoy_candidates(const Confrontation& state, const NamingOptions& options) {
  std::vector<Index> order, decoys;
  for (const HypothesisFit& fit : state.conclusion.singles) order.push_back(fit.causes.front());
  NamingOptions all = options;
  all.near = std::numeric_limits<double>::max();
  all.most = state.evidence.candidates.size();
  for (const Index k : refit_candidates(state.gate, all)) {
    if (!among(state.conclusion.singles, k)) order.push_back(k);
  }
  for (const Index k : order) {
    if (decoys.size() < kDecoys && !among(state.conclusion.kept, k)) decoys.push_back(k);
  }
  return decoys;
}

/// A candidate's own fit: the one that was judged, or one made now.
HypothesisFit single_fit(const Confrontation& state, Index cause, const HypothesisMaker& make) {
  const std::vector<HypothesisFit>& singles = state.conclusion.singles;
  const auto judged =
      std::find_if(singles.begin(), singles.end(), [&](const HypothesisFit& f) { return f.causes.front() == cause; });
  if (judged != singles.end()) return *judged;
  return fit_hypothesis(state.scatter.covariance, state.evidence.candidates, make({{cause}}).front());
}

void compare_kept_back(const ConfrontationTask& task, Confrontation& state) {
  state.kept_back = compare(state.evidence, TestUse::hold_out);
  if (state.kept_back.data.size() > 0)
    state.kept_back_scatter = scatter_at(state.kept_back, state.base.coded, task.options.draws.noise);
}

void measure_gains(const ConfrontationTask& task, Confrontation& state, const HypothesisMaker& make) {
  for (const HypothesisFit& fit : state.conclusion.kept) state.extensions.push_back(extension_gain(task, state, fit));
  for (const Index k : decoy_candidates(state, task.options)) {
    state.decoys.push_back(extension_gain(task, state, single_fit(state, k, make)));
  }
}

/// Kept causes whose runs lack a peak are believed after all others.
void put_short_runs_last(const ConfrontationTask& task, Confrontation& state) {
  std::vector<HypothesisFit>& kept = state.conclusion.kept;
  for (const HypothesisFit& fit : kept) {
    for (ShortRuns& found : short_runs(task, state, fit)) state.short_runs.push_back(std::move(found));
  }
  std::stable_partition(kept.begin(), kept.end(), [&](const HypothesisFit& fit) {
    return std::none_of(state.short_runs.begin(), state.short_runs.end(),
                        [&](const ShortRuns& s) { return s.causes == fit.causes; });
  });
}

/// A bend moves the fit a little, so the parameters' limits are looked at with and without it.
std::vector<Hypothesis> linear_hypotheses(const Confrontation& state, const std::vector<std::vector<Index>>& lists) {
  const Eigen::MatrixXd& covariance = state.scatter.covariance;
  const std::vector<Candidate>& candidates = state.evidence.candidates;
  const auto within = [&](Hypothesis h) {
    return held_within(std::move(h), state.evidence.parameters, covariance, candidates);
  };
  std::vector<Hypothesis> hypotheses;
  for (const std::vector<Index>& causes : lists) {
    Hypothesis straight = within(linear_hypothesis(state.fitted, state.base, causes));
    hypotheses.push_back(within(with_bend(std::move(straight), state.fitted, covariance, candidates)));
  }
  return hypotheses;
}

}  // namespace

Confrontation confront(ConfrontationTask task) {
  Confrontation state;
  state.evidence = task.evidence;
  state.centre = VectorXd::Zero(static_cast<Index>(task.evidence.parameters.size()));
  const bool by_runs = task.linearised_at == LinearisedAt::calibrated;
  if (by_runs && !state.evidence.parameters.empty()) calibrate_by_runs(task, state);
  simulate_effects(task, state);
  state.gate = gate_apart(state, task.options.draws);
  const HypothesisMaker make = [&](const std::vector<std::vector<Index>>& lists) {
    return by_runs ? hypotheses_by_runs(task, state, lists) : linear_hypotheses(state, lists);
  };
  state.conclusion =
      conclude(state.fitted, state.scatter, state.base, state.gate, state.evidence.candidates, make, task.options);
  state.residuals = feature_residuals(state.fitted, state.scatter, state.base, state.evidence.parameters);
  if (state.conclusion.kept.empty()) return state;
  compare_kept_back(task, state);
  if (by_runs) put_short_runs_last(task, state);
  measure_gains(task, state, make);
  return state;
}

}  // namespace asperity
