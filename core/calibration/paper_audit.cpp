#include "core/calibration/paper_audit.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/error.hpp"

namespace asperity {
namespace {

double printed_number(const std::string& text) {
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// Half a unit of the last printed digit, and the rounding of double precision.
double half_digit(const std::string& text) {
  const std::size_t point = text.find('.');
  const std::size_t decimals = point == std::string::npos ? 0 : text.size() - point - 1;
  return 0.5 * std::pow(10.0, -static_cast<double>(decimals)) * (1.0 + 1e-9);
}

bool rounds_to(double value, const std::string& printed) {
  return std::abs(value - printed_number(printed)) <= half_digit(printed);
}

Term term_of(const LinearFit& fit, const std::string& name) {
  const auto found =
      std::find_if(fit.terms.begin(), fit.terms.end(), [&](Term term) { return term_name(term) == name; });
  return found == fit.terms.end() ? Term{} : *found;
}

double fitted_coefficient(const LinearFit& fit, const std::string& name) {
  const auto place = index_of(fit, term_of(fit, name));
  return place ? fit.coefficients[*place] : 0.0;
}

bool stands_in(const std::vector<PublishedTerm>& terms, const std::string& name) {
  return std::any_of(terms.begin(), terms.end(), [&](const PublishedTerm& term) { return term.name == name; });
}

/// A term printed a second time stands for the missing one whose fitted coefficient rounds to what is printed.
std::string meant_by(const LinearFit& fit, const PublishedEquation& equation, std::size_t place) {
  const PublishedTerm& term = equation.terms[place];
  const std::vector<PublishedTerm> before(equation.terms.begin(),
                                          equation.terms.begin() + static_cast<std::ptrdiff_t>(place));
  if (!stands_in(before, term.name)) return term.name;
  for (const Term& other : fit.terms) {
    const std::string name = term_name(other);
    if (!stands_in(equation.terms, name) && rounds_to(fitted_coefficient(fit, name), term.coefficient)) return name;
  }
  return term.name;
}

void audit_terms(AuditedEquation& audited, const LinearFit& fit, const PublishedEquation& equation) {
  for (std::size_t i = 0; i < equation.terms.size(); ++i) {
    const PublishedTerm& term = equation.terms[i];
    const std::string meant = meant_by(fit, equation, i);
    const double fitted = fitted_coefficient(fit, meant);
    audited.terms.push_back({term.name, meant, term.coefficient, fitted, rounds_to(fitted, term.coefficient)});
  }
}

void evaluate_at(AuditedEquation& audited, const LinearFit& fit, const std::vector<double>& x) {
  for (const AuditedTerm& term : audited.terms) {
    const double coefficient = printed_number(term.printed);
    audited.at_solution_as_printed += coefficient * term_value(term_of(fit, term.name), x);
    audited.at_solution_mended += coefficient * term_value(term_of(fit, term.meant), x);
  }
  audited.at_solution_fitted = evaluate(fit, x);
}

/// The printed equation, misprints mended, as far as extremes() reads it.
LinearFit mended(const AuditedEquation& audited, const LinearFit& fit) {
  LinearFit printed;
  for (const AuditedTerm& term : audited.terms) {
    printed.terms.push_back(term_of(fit, term.meant));
    printed.coefficients.push_back(printed_number(term.printed));
  }
  return printed;
}

void find_reach(AuditedEquation& audited, const LinearFit& fit, const Response& response, double alpha) {
  std::vector<double> values;
  std::copy_if(response.values.begin(), response.values.end(), std::back_inserter(values),
               [](double v) { return std::isfinite(v); });
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  audited.smallest_run = *low;
  audited.largest_run = *high;
  std::tie(audited.smallest_inside, audited.largest_inside) = extremes(fit, alpha);
  std::tie(audited.smallest_printed, audited.largest_printed) = extremes(mended(audited, fit), alpha);
  audited.target_inside = audited.claimed >= audited.smallest_inside && audited.claimed <= audited.largest_inside;
}

double centre_scatter(const Design& design, const Response& response) {
  double sum = 0.0, square = 0.0, n = 0.0;
  for (std::size_t i = 0; i < design.kind.size(); ++i) {
    if (design.kind[i] != PointKind::centre || !std::isfinite(response.values[i])) continue;
    sum += response.values[i];
    square += response.values[i] * response.values[i];
    n += 1.0;
  }
  const double mean = sum / n;
  return std::sqrt((square - n * mean * mean) / (n - 1.0)) / mean;
}

template <class List, class Name>
const auto& named(const List& list, const Name& is_named, const std::string& property) {
  const auto found = std::find_if(list.begin(), list.end(), is_named);
  if (found != list.end()) return *found;
  throw Error(ErrorKind::config, {{"/published/equations/" + property, "is of no target with a response", "", "", ""}});
}

AuditedEquation audit_equation(const DataCalibration& calibration, const Analysis& analysis,
                               const PublishedEquation& equation) {
  const std::string& property = equation.property;
  const auto by_name = [&](const auto& item) { return item.name == property; };
  const Target& target = named(
      calibration.targets, [&](const Target& t) { return t.property == property; }, property);
  const LinearFit& fit = named(analysis.models, by_name, property).full;
  const Response& response = named(calibration.responses.list, by_name, property);
  AuditedEquation audited;
  audited.property = property;
  audited.label = equation.label;
  audited.r2 = fit.r2;
  audited.claimed = target.value;
  audit_terms(audited, fit, equation);
  evaluate_at(audited, fit, calibration.published->coded);
  find_reach(audited, fit, response, calibration.design.alpha);
  audited.centre_scatter = centre_scatter(calibration.design, response);
  for (const auto& [name, scatter] : calibration.published->scatter) {
    if (name == property) audited.claimed_scatter = scatter;
  }
  return audited;
}

/// Straight line through (coded, tabled); NaN where the table has no real values.
std::pair<double, double> line_of(const DataCalibration& calibration, std::size_t factor) {
  double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (std::size_t i = 0; i < calibration.tabled.size(); ++i) {
    const double x = calibration.design.coded[i][factor], y = calibration.tabled[i][factor];
    n += 1.0;
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  const double step = (n * sxy - sx * sy) / (n * sxx - sx * sx);
  return {(sy - step * sx) / n, step};
}

AuditedFactor audit_factor(const DataCalibration& calibration, std::size_t j) {
  AuditedFactor audited;
  audited.stated = calibration.design.factors[j];
  std::tie(audited.tabled_centre, audited.tabled_step) = line_of(calibration, j);
  const double coded = calibration.published->coded[j];
  audited.solution = decode(audited.stated, coded);
  audited.printed = calibration.published->parameters[j];
  audited.solution_agrees = rounds_to(audited.solution, audited.printed);
  audited.solution_by_table = audited.tabled_centre + audited.tabled_step * coded;
  return audited;
}

bool solved_in_full(const DataCalibration& calibration) {
  AnalysisOptions options = calibration.options;
  options.model.elimination_level = 1.0;
  options.bootstrap_draws = 0;
  return !analyse(calibration.design, calibration.responses, calibration.targets, options).solutions.empty();
}

}  // namespace

bool is_printed_number(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

PaperAudit audit_paper(const DataCalibration& calibration, const Analysis& analysis) {
  const Published& published = calibration.published.value();
  PaperAudit audit;
  audit.source = published.source;
  audit.alpha = calibration.design.alpha;
  audit.corner = std::sqrt(static_cast<double>(calibration.design.factors.size()));
  audit.runs = calibration.design.coded.size();
  const std::vector<PointKind>& kinds = calibration.design.kind;
  audit.centre_points = static_cast<std::size_t>(std::count(kinds.begin(), kinds.end(), PointKind::centre));
  for (const PublishedEquation& equation : published.equations) {
    audit.equations.push_back(audit_equation(calibration, analysis, equation));
  }
  for (std::size_t j = 0; j < calibration.design.factors.size(); ++j) {
    audit.factors.push_back(audit_factor(calibration, j));
  }
  audit.solved = !analysis.solutions.empty();
  audit.solved_in_full = solved_in_full(calibration);
  audit.compromise = analysis.compromise;
  return audit;
}

}  // namespace asperity
