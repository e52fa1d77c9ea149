#include "core/confrontation/conclusion.hpp"

#include <algorithm>

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
  if (conclusion.kept.size() > 1) {
    conclusion.status = VerdictStatus::indistinguishable;
    return conclusion;
  }
  const bool named = !conclusion.kept.empty();
  if (named) conclusion.status = VerdictStatus::named;
  const std::vector<HypothesisFit>& firsts = named ? conclusion.kept : conclusion.singles;
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
  if (pairs.empty()) return conclusion;
  conclusion.pairs = judge(comparison, scatter, fit, candidates, make(pairs), options);
  for (HypothesisFit& pair : conclusion.pairs) pair.kept = pair.kept && both_act(pair);
  sort_by_likelihood(conclusion.pairs);
  const std::vector<HypothesisFit> kept = kept_of(conclusion.pairs);
  if (kept.empty()) return conclusion;
  conclusion.kept = kept;
  conclusion.status = VerdictStatus::two_causes;
  return conclusion;
}

}  // namespace asperity
