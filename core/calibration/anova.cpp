#include "core/calibration/anova.hpp"

#include <map>
#include <openturns/FisherSnedecor.hxx>

namespace asperity {
namespace {

double upper_tail(double f, int df, int residual_df) {
  return OT::FisherSnedecor(df, residual_df).computeComplementaryCDF(f);
}

/// A source tested against a mean square of `against` with its degrees of freedom.
struct Yardstick {
  double mean_square;
  int df;
};

AnovaLine tested(const std::string& source, int df, double sum_of_squares, const Yardstick& against) {
  AnovaLine line{source, df, sum_of_squares, {}, {}, {}};
  if (df == 0) return line;
  line.mean_square = sum_of_squares / df;
  line.f = *line.mean_square / against.mean_square;
  line.p = upper_tail(*line.f, df, against.df);
  return line;
}

AnovaLine untested(const std::string& source, int df, double sum_of_squares) {
  AnovaLine line{source, df, sum_of_squares, {}, {}, {}};
  if (df > 0) line.mean_square = sum_of_squares / df;
  return line;
}

/// Terms up to and with this kind.
std::vector<Term> terms_up_to(const LinearFit& fit, TermKind last) {
  std::vector<Term> terms;
  for (const Term& term : fit.terms) {
    if (kind_of(term) <= last) terms.push_back(term);
  }
  return terms;
}

/// Sequential sums of squares of the three groups, Eq. (S10).
void add_groups(Anova& table, const Observations& observed, const LinearFit& full, const Yardstick& residual) {
  const std::pair<TermKind, const char*> groups[] = {
      {TermKind::linear, "linear"}, {TermKind::interaction, "interactions"}, {TermKind::square, "quadratic"}};
  double before = full.total_sum_of_squares;
  std::size_t terms_before = 1;
  for (const auto& [kind, name] : groups) {
    const std::vector<Term> terms = terms_up_to(full, kind);
    const double left = terms.size() == full.terms.size() ? full.residual_sum_of_squares
                                                          : fit_terms(observed, terms).residual_sum_of_squares;
    table.lines.push_back(tested(name, static_cast<int>(terms.size() - terms_before), before - left, residual));
    before = left;
    terms_before = terms.size();
  }
}

/// What each term explains beyond all others.
void add_terms(Anova& table, const LinearFit& full, const Yardstick& residual) {
  const std::size_t p = full.terms.size();
  for (std::size_t i = 1; i < p; ++i) {
    const double square = full.coefficients[i] * full.coefficients[i] / full.gram_inverse[i * p + i];
    table.lines.push_back(tested(term_name(full.terms[i]), 1, square, residual));
  }
}

/// Eq. (S12).
void add_lack_of_fit(Anova& table, const LinearFit& full) {
  if (!table.pure_error) return;
  const PureError& pure = *table.pure_error;
  const int df = full.residual_df - pure.df;
  const double sum = full.residual_sum_of_squares - pure.sum_of_squares;
  if (df > 0 && pure.sum_of_squares > 0.0) {
    const AnovaLine line = tested("lack_of_fit", df, sum, {pure.sum_of_squares / pure.df, pure.df});
    table.lines.push_back(line);
    table.lack_of_fit = LackOfFit{df, sum, *line.f, *line.p};
  }
  table.lines.push_back(untested("pure_error", pure.df, pure.sum_of_squares));
}

}  // namespace

std::optional<PureError> pure_error(const Observations& observed) {
  std::map<std::vector<double>, std::vector<double>> groups;
  for (std::size_t i = 0; i < observed.y.size(); ++i) groups[observed.x[i]].push_back(observed.y[i]);
  PureError pure;
  for (const auto& [levels, values] : groups) {
    double mean = 0.0;
    for (double y : values) mean += y / static_cast<double>(values.size());
    for (double y : values) pure.sum_of_squares += (y - mean) * (y - mean);
    pure.df += static_cast<int>(values.size()) - 1;
  }
  if (pure.df == 0) return std::nullopt;
  return pure;
}

Anova analyse_variance(const Observations& observed, const LinearFit& full) {
  const Yardstick residual{full.residual_sd * full.residual_sd, full.residual_df};
  const int n = static_cast<int>(observed.y.size()), p = static_cast<int>(full.terms.size());
  Anova table;
  table.pure_error = pure_error(observed);
  table.lines.push_back(tested("model", p - 1, full.total_sum_of_squares - full.residual_sum_of_squares, residual));
  add_groups(table, observed, full, residual);
  add_terms(table, full, residual);
  table.lines.push_back(untested("residual", full.residual_df, full.residual_sum_of_squares));
  add_lack_of_fit(table, full);
  table.lines.push_back(untested("total", n - 1, full.total_sum_of_squares));
  return table;
}

}  // namespace asperity
