#include "core/confrontation/conclusion.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace asperity {
namespace {

using Eigen::Index;

/// By likelihood, Eq. (N23).
void sort_by_likelihood(std::vector<HypothesisFit>& fits) {
  std::stable_sort(fits.begin(), fits.end(), [](const HypothesisFit& a, const HypothesisFit& b) {
    return a.misfit + a.widening < b.misfit + b.widening;
  });
}

std::vector<HypothesisFit> kept_of(const std::vector<HypothesisFit>& fits) {
  std::vector<HypothesisFit> kept;
  for (const HypothesisFit& f : fits) {
    if (f.kept) kept.push_back(f);
  }
  return kept;
}

std::vector<std::vector<Index>> one_each(const std::vector<Index>& candidates) {
  std::vector<std::vector<Index>> lists;
  for (const Index k : candidates) lists.push_back({k});
  return lists;
}

const Hypothesis& of_cause(const std::vector<Hypothesis>& hypotheses, Index cause) {
  return *std::find_if(hypotheses.begin(), hypotheses.end(),
                       [&](const Hypothesis& h) { return h.causes.front() == cause; });
}

bool same_pair(const std::vector<Index>& a, const std::vector<Index>& b) {
  return a == b || (a[0] == b[1] && a[1] == b[0]);
}

const Candidate& candidate_of(const std::vector<Candidate>& candidates, const HypothesisFit& single) {
  return candidates[static_cast<std::size_t>(single.causes.front())];
}

bool among(const std::vector<std::string>& ids, const std::string& id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

/// Those that are known to be taken for a kept one are kept, too, unless their own misfit refutes them or, where the
/// test that tells the two apart was made, they fit worse by two standard deviations; Eq. (N25).
void keep_doubles(const std::vector<Candidate>& candidates, double level, std::vector<HypothesisFit>& singles) {
  constexpr double kWorse = 4.0;
  const std::vector<HypothesisFit> kept = kept_of(singles);
  for (HypothesisFit& single : singles) {
    const std::string& id = candidate_of(candidates, single).id;
    const bool is_double = std::any_of(kept.begin(), kept.end(), [&](const HypothesisFit& other) {
      const Candidate& cause = candidate_of(candidates, other);
      const bool near = single.misfit - other.misfit < kWorse;
      return among(cause.doubles, id) || (near && among(cause.tested_doubles, id));
    });
    single.kept = single.kept || (is_double && single.p_misfit >= level);
  }
}

/// Pairs that are worth a refit: the kept single, or where there is none the best ones, each with the second cause that
/// its remainder shows. Notes what was sought.
std::vector<std::vector<Index>> second_causes(const Comparison& comparison, const Scatter& scatter, const BaseFit& fit,
                                              const std::vector<Candidate>& candidates,
                                              const std::vector<Hypothesis>& hypotheses, const NamingOptions& options,
                                              Conclusion& conclusion) {
  const std::vector<HypothesisFit>& firsts = conclusion.kept.empty() ? conclusion.singles : conclusion.kept;
  std::vector<std::vector<Index>> pairs;
  for (std::size_t i = 0; i < std::min(firsts.size(), options.most_pairs); ++i) {
    const Index first = firsts[i].causes.front();
    conclusion.seconds.push_back(
        second_cause(comparison, scatter, fit, candidates, of_cause(hypotheses, first), options));
    const SecondCause& second = conclusion.seconds.back();
    const std::vector<Index> pair{first, second.candidate};
    const auto listed = std::any_of(pairs.begin(), pairs.end(), [&](const auto& p) { return same_pair(p, pair); });
    if (second.candidate >= 0 && second.p < options.level && !listed) pairs.push_back(pair);
  }
  return pairs;
}

}  // namespace

std::string_view word(VerdictStatus status) {
  switch (status) {
    case VerdictStatus::nothing_found:
      return "nothing_found";
    case VerdictStatus::named:
      return "named";
    case VerdictStatus::indistinguishable:
      return "indistinguishable";
    case VerdictStatus::two_causes:
      return "two_causes";
    case VerdictStatus::unexplained:
      break;
  }
  return "unexplained";
}

bool both_act(const HypothesisFit& pair) {
  constexpr double kErrors = 2.0;
  return (pair.amplitude.array().abs() > kErrors * pair.amplitude_error.array()).all();
}

Conclusion conclude(const Comparison& comparison, const Scatter& scatter, const BaseFit& fit, const Gate& gate,
                    const std::vector<Candidate>& candidates, const HypothesisMaker& make,
                    const NamingOptions& options) {
  Conclusion conclusion;
  if (!gate.discrepancy) return conclusion;
  conclusion.status = VerdictStatus::unexplained;
  const std::vector<Hypothesis> hypotheses = make(one_each(refit_candidates(gate, options)));
  if (hypotheses.empty()) return conclusion;
  conclusion.singles = judge(comparison, scatter, fit, candidates, hypotheses, options);
  sort_by_likelihood(conclusion.singles);
  conclusion.kept = kept_of(conclusion.singles);
  if (conclusion.kept.size() < 2) {
    const auto pairs = second_causes(comparison, scatter, fit, candidates, hypotheses, options, conclusion);
    if (!pairs.empty()) {
      conclusion.pairs = judge(comparison, scatter, fit, candidates, make(pairs), options);
      for (HypothesisFit& pair : conclusion.pairs) pair.kept = pair.kept && both_act(pair);
      sort_by_likelihood(conclusion.pairs);
    }
  }
  if (std::vector<HypothesisFit> kept = kept_of(conclusion.pairs); !kept.empty()) {
    conclusion.kept = std::move(kept);
    conclusion.status = VerdictStatus::two_causes;
    return conclusion;
  }
  keep_doubles(candidates, options.level, conclusion.singles);
  conclusion.kept = kept_of(conclusion.singles);
  if (conclusion.kept.size() == 1) conclusion.status = VerdictStatus::named;
  if (conclusion.kept.size() > 1) conclusion.status = VerdictStatus::indistinguishable;
  return conclusion;
}

}  // namespace asperity
