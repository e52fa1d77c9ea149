#include "core/confrontation/verdict_json.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

using Eigen::Index;
using nlohmann::ordered_json;

constexpr std::size_t kMostCauses = 5;
constexpr double kTooGood = 1e-3;  // share of repetitions below which a fit is too good

ordered_json number(double value) { return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr); }

const Candidate& candidate(const Confrontation& c, Index k) {
  return c.evidence.candidates[static_cast<std::size_t>(k)];
}

ordered_json numbers(const Eigen::VectorXd& values) {
  ordered_json list = ordered_json::array();
  for (const double v : values) list.push_back(number(v));
  return list;
}

ordered_json ids(const Confrontation& c, const std::vector<Index>& causes) {
  ordered_json list = ordered_json::array();
  for (const Index k : causes) list.push_back(candidate(c, k).id);
  return list;
}

ordered_json single_json(const Confrontation& c, const HypothesisFit& fit) {
  const Index k = fit.causes.front();
  return {{"id", candidate(c, k).id},
          {"amplitude", number(fit.amplitude(0))},
          {"amplitude_error", number(fit.amplitude_error(0))},
          {"misfit", number(fit.misfit)},
          {"kept", fit.kept},
          {"converged", fit.converged},
          {"p_misfit", fit.p_misfit},
          {"p_excess", fit.p_excess},
          {"explained", number(c.gate.pattern.explained(k))},
          {"absorbed_share", number(c.gate.hidden_share(k))},
          {"suspect", candidate(c, k).suspect}};
}

ordered_json pair_json(const Confrontation& c, const HypothesisFit& fit) {
  return {{"ids", ids(c, fit.causes)},
          {"amplitudes", numbers(fit.amplitude)},
          {"amplitude_errors", numbers(fit.amplitude_error)},
          {"misfit", number(fit.misfit)},
          {"kept", fit.kept},
          {"both_act", both_act(fit)},
          {"converged", fit.converged},
          {"p_misfit", fit.p_misfit},
          {"p_excess", fit.p_excess}};
}

ordered_json wrong_json(const Confrontation& c) {
  std::vector<FeatureResidual> sorted = c.residuals;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const FeatureResidual& a, const FeatureResidual& b) { return std::abs(a.z) > std::abs(b.z); });
  ordered_json list = ordered_json::array();
  for (const FeatureResidual& r : sorted) {
    list.push_back({{"test", r.test},
                    {"feature", r.feature},
                    {"measured", number(r.measured)},
                    {"simulated", number(r.simulated)},
                    {"z", number(r.z)},
                    {"percent", number(r.percent)},
                    {"simulated_left_out", number(r.simulated_left_out)},
                    {"z_left_out", number(r.z_left_out)}});
  }
  return list;
}

ordered_json gain_json(const Gain& gain) {
  ordered_json features = ordered_json::array();
  for (const FeatureGain& f : gain.features) {
    features.push_back({{"test", f.test},
                        {"feature", f.feature},
                        {"measured", number(f.measured)},
                        {"before", number(f.before)},
                        {"after", number(f.after)},
                        {"z_before", number(f.z_before)},
                        {"z_after", number(f.z_after)}});
  }
  return {{"elpd_change", number(gain.elpd_change)},
          {"elpd_interval_90", {number(gain.low), number(gain.high)}},
          {"claimed", gain.claimed()},
          {"rms_z_before", number(gain.rms_before)},
          {"rms_z_after", number(gain.rms_after)},
          {"features", std::move(features)}};
}

/// Of the best extension, with the others and the decoys beside it.
ordered_json gains_json(const Confrontation& c) {
  ordered_json json = {{"causes", ordered_json::array()},
                       {"elpd_change", nullptr},
                       {"elpd_interval_90", nullptr},
                       {"claimed", false},
                       {"features", ordered_json::array()}};
  const auto listed = [&](const std::vector<ExtensionGain>& extensions, std::size_t first) {
    ordered_json list = ordered_json::array();
    for (std::size_t i = first; i < extensions.size(); ++i) {
      if (!extensions[i].gain) continue;
      ordered_json entry = {{"causes", ids(c, extensions[i].fit.causes)}};
      entry.update(gain_json(*extensions[i].gain));
      entry.erase("features");
      list.push_back(std::move(entry));
    }
    return list;
  };
  if (!c.extensions.empty()) {
    const ExtensionGain& best = c.extensions.front();
    if (best.gain) json.update(gain_json(*best.gain));
    json["causes"] = ids(c, best.fit.causes);
  }
  json["others"] = listed(c.extensions, 1);
  json["decoys"] = listed(c.decoys, 0);
  return json;
}

ordered_json detectable_json(const Confrontation& c) {
  ordered_json json = ordered_json::object();
  for (std::size_t k = 0; k < c.evidence.candidates.size(); ++k)
    json[c.evidence.candidates[k].id] = number(c.gate.detectable(static_cast<Index>(k)));
  return json;
}

ordered_json cosines_json(const Confrontation& c) {
  const WhitenedFrame frame(c.scatter.covariance, c.base.absorbing);
  const Eigen::MatrixXd projected = projected_fingerprints(frame, c.base.difference, c.fitted);
  ordered_json list = ordered_json::array();
  for (std::size_t i = 0; i < c.conclusion.singles.size(); ++i) {
    for (std::size_t j = i + 1; j < c.conclusion.singles.size(); ++j) {
      const Index a = c.conclusion.singles[i].causes.front(), b = c.conclusion.singles[j].causes.front();
      list.push_back({{"ids", {candidate(c, a).id, candidate(c, b).id}},
                      {"cosine", number(cosine(projected.col(a), projected.col(b)))}});
    }
  }
  return list;
}

ordered_json gate_json(const Gate& gate) {
  ordered_json alarms = ordered_json::array();
  if (gate.p_too_good < kTooGood) alarms.push_back("the data agree with the simulation better than scatter allows");
  if (gate.left == 0)
    alarms.push_back("calibration absorbs every compared feature: nothing is left to judge the model by");
  return {{"discrepancy", gate.discrepancy},   {"misfit", number(gate.pattern.misfit)},
          {"p_misfit", number(gate.p_misfit)}, {"p_explained", gate.p_explained},
          {"p_too_good", gate.p_too_good},     {"alarms", std::move(alarms)}};
}

ordered_json parameters_json(const std::vector<ParameterValue>& parameters) {
  ordered_json list = ordered_json::array();
  for (const ParameterValue& p : parameters) {
    list.push_back({{"name", p.name},
                    {"label", p.label},
                    {"unit", p.unit},
                    {"value", number(p.value)},
                    {"error", number(p.error)},
                    {"determined", p.determined},
                    {"at_limit", p.limited}});
  }
  return list;
}

ordered_json extended_json(const std::vector<ParameterValue>& parameters) {
  ordered_json list = ordered_json::array();
  for (const ParameterValue& p : parameters)
    list.push_back({{"name", p.name}, {"value", number(p.value)}, {"error", number(p.error)}});
  return list;
}

ordered_json next_json(const VerdictContext& context) {
  ordered_json list = ordered_json::array();
  for (const NextTest& n : context.next_tests) {
    list.push_back({{"id", n.id},
                    {"description", n.description},
                    {"changes", n.changes},
                    {"separates", n.separates},
                    {"distance", number(n.distance)},
                    {"probability_correct", number(n.probability_correct)}});
  }
  return list;
}

ordered_json short_runs_json(const Confrontation& c) {
  ordered_json list = ordered_json::array();
  for (const ShortRuns& s : c.short_runs) {
    list.push_back({{"causes", ids(c, s.causes)},
                    {"test", s.test},
                    {"feature", s.feature},
                    {"base", s.base},
                    {"extension", s.extension},
                    {"meshes", s.meshes}});
  }
  return list;
}

ordered_json dropped_json(const Confrontation& c) {
  ordered_json list = ordered_json::array();
  for (const DroppedSlot& d : c.fitted.dropped)
    list.push_back({{"test", d.test}, {"feature", d.feature}, {"why", d.why}});
  return list;
}

}  // namespace

std::string causes_text(const Confrontation& c, const std::vector<Index>& causes) {
  std::string text;
  for (const Index k : causes) text += (text.empty() ? "" : " + ") + candidate(c, k).id;
  return text;
}

std::vector<std::string> verdict_causes(const Confrontation& c) {
  std::vector<std::string> causes;
  if (c.conclusion.kept.empty()) return causes;
  if (c.conclusion.status == VerdictStatus::two_causes) {
    for (const Index k : c.conclusion.kept.front().causes) causes.push_back(candidate(c, k).id);
    return causes;
  }
  for (const bool suspects : {true, false}) {
    for (const HypothesisFit& fit : c.conclusion.kept) {
      const Candidate& cause = candidate(c, fit.causes.front());
      if (cause.suspect == suspects && causes.size() < kMostCauses) causes.push_back(cause.id);
    }
  }
  return causes;
}

ordered_json verdict_json(const Confrontation& c, const VerdictContext& context) {
  ordered_json candidates = ordered_json::array(), pairs = ordered_json::array();
  for (const HypothesisFit& fit : c.conclusion.singles) candidates.push_back(single_json(c, fit));
  for (const HypothesisFit& fit : c.conclusion.pairs) pairs.push_back(pair_json(c, fit));
  ordered_json json = {{"status", word(c.conclusion.status)},
                       {"causes", verdict_causes(c)},
                       {"candidates", std::move(candidates)},
                       {"pairs", std::move(pairs)},
                       {"cosines", cosines_json(c)},
                       {"gate", gate_json(c.gate)},
                       {"parameters", parameters_json(context.parameters)},
                       {"extended_parameters", extended_json(context.extended_parameters)},
                       {"wrong", wrong_json(c)},
                       {"detectable_amplitude", detectable_json(c)},
                       {"gain", gains_json(c)},
                       {"next_tests", next_json(context)},
                       {"left_out", dropped_json(c)},
                       {"short_runs", short_runs_json(c)},
                       {"notes", context.notes}};
  json["extended_config"] =
      context.extended_config.empty() ? ordered_json(nullptr) : ordered_json(context.extended_config);
  json["data_sha256"] = context.data_sha256;
  json["frozen_sha256"] = context.frozen_sha256;
  return json;
}

}  // namespace asperity
