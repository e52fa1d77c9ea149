#include "core/calibration/terms.hpp"

namespace asperity {
namespace {

std::string factor_name(int factor) { return "x" + std::to_string(factor + 1); }

double level(std::span<const double> x, int factor) { return factor < 0 ? 1.0 : x[static_cast<std::size_t>(factor)]; }

}  // namespace

TermKind kind_of(Term term) {
  if (term.first < 0) return TermKind::constant;
  if (term.second < 0) return TermKind::linear;
  return term.first == term.second ? TermKind::square : TermKind::interaction;
}

std::string term_name(Term term) {
  switch (kind_of(term)) {
    case TermKind::constant:
      return "1";
    case TermKind::linear:
      return factor_name(term.first);
    case TermKind::square:
      return factor_name(term.first) + "^2";
    case TermKind::interaction:
      break;
  }
  return factor_name(term.first) + factor_name(term.second);
}

double term_value(Term term, std::span<const double> x) { return level(x, term.first) * level(x, term.second); }

double term_derivative(Term term, std::span<const double> x, int factor) {
  double sum = 0.0;
  if (term.first == factor) sum += level(x, term.second);
  if (term.second == factor) sum += level(x, term.first);
  return sum;
}

std::vector<Term> quadratic_terms(std::size_t factors) {
  const int k = static_cast<int>(factors);
  std::vector<Term> terms{Term{}};
  for (int i = 0; i < k; ++i) terms.push_back({i, -1});
  for (int i = 0; i < k; ++i) {
    for (int j = i + 1; j < k; ++j) terms.push_back({i, j});
  }
  for (int i = 0; i < k; ++i) terms.push_back({i, i});
  return terms;
}

bool is_parent(Term lower, Term higher) {
  if (kind_of(lower) != TermKind::linear || higher.second < 0) return false;
  return higher.first == lower.first || higher.second == lower.first;
}

}  // namespace asperity
