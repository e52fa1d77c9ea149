#include "core/calibration/elimination.hpp"

#include <algorithm>

namespace asperity {
namespace {

bool may_go(const std::vector<Term>& terms, Term term, Hierarchy hierarchy) {
  if (kind_of(term) == TermKind::constant) return false;
  if (hierarchy == Hierarchy::free) return true;
  return std::none_of(terms.begin(), terms.end(), [&](Term other) { return is_parent(term, other); });
}

/// Place of the removable term with the largest p value above the level; the number of terms if there is none. Of equal
/// p values the last term goes: squares before interactions before linear terms.
std::size_t weakest(const LinearFit& fit, double level, Hierarchy hierarchy) {
  std::size_t found = fit.terms.size();
  double largest = level;
  for (std::size_t i = 0; i < fit.terms.size(); ++i) {
    const bool weaker = found == fit.terms.size() ? fit.p_values[i] > largest : fit.p_values[i] >= largest;
    if (!weaker || !may_go(fit.terms, fit.terms[i], hierarchy)) continue;
    found = i;
    largest = fit.p_values[i];
  }
  return found;
}

}  // namespace

Elimination eliminate(const Observations& observed, const LinearFit& full, double level, Hierarchy hierarchy) {
  Elimination result{full, {}};
  for (;;) {
    const std::size_t gone = weakest(result.fit, level, hierarchy);
    if (gone == result.fit.terms.size()) return result;
    result.eliminated.push_back(term_name(result.fit.terms[gone]));
    std::vector<Term> rest = result.fit.terms;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(gone));
    result.fit = fit_terms(observed, rest);
  }
}

}  // namespace asperity
