#include "app/report/response_surface.hpp"

#include <Eigen/Dense>
#include <charconv>
#include <cmath>

#include "core/base/error.hpp"

namespace asperity::app {
namespace {

[[noreturn]] void refuse(const std::string& term) {
  throw Error(ErrorKind::config, {{"/models", "names a term that is none of these factors", term,
                                   "1, x1, x1x2, x1^2 and their like", ""}});
}

/// The factor's number at the head of the text, which loses it: "x12x3" gives 12 and leaves "x3".
std::size_t take_factor(std::string_view& text, const std::string& term, std::size_t factors) {
  std::size_t number = 0;
  if (!text.starts_with('x')) refuse(term);
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), number);
  if (error != std::errc() || number < 1 || number > factors) refuse(term);
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number - 1;
}

/// Cornish and Fisher's expansion of the 97.5 % quantile of Student's t about the normal one.
double t_quantile(double df) {
  constexpr double z = 1.959963984540054;
  const double z3 = z * z * z, z5 = z3 * z * z, z7 = z5 * z * z;
  return z + (z3 + z) / (4 * df) + (5 * z5 + 16 * z3 + 3 * z) / (96 * df * df) +
         (3 * z7 + 19 * z5 + 17 * z3 - 15 * z) / (384 * df * df * df);
}

}  // namespace

double term_value(const std::string& term, const std::vector<double>& coded) {
  if (term == "1") return 1;
  double product = 1;
  for (std::string_view rest = term; !rest.empty();) {
    const double level = coded[take_factor(rest, term, coded.size())];
    const bool squared = rest.starts_with("^2");
    if (squared) rest.remove_prefix(2);
    product *= squared ? level * level : level;
  }
  return product;
}

ResponseSurface::ResponseSurface(std::vector<Term> terms, const std::vector<std::vector<double>>& runs)
    : terms_(std::move(terms)) {
  constexpr int kFewestDf = 5;
  const auto n = static_cast<Eigen::Index>(runs.size()), p = static_cast<Eigen::Index>(terms_.size());
  if (p == 0 || n - p < kFewestDf) return;
  Eigen::MatrixXd x(n, p);
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::vector<double> r = row(runs[static_cast<std::size_t>(i)]);
    x.row(i) = Eigen::Map<const Eigen::RowVectorXd>(r.data(), p);
  }
  const Eigen::FullPivLU<Eigen::MatrixXd> normal(x.transpose() * x);
  if (!normal.isInvertible()) return;
  const Eigen::MatrixXd inverse = normal.inverse();
  // The residual variance is in any coefficient's standard error.
  const double variance = terms_[0].standard_error * terms_[0].standard_error / inverse(0, 0);
  if (!std::isfinite(variance)) return;
  for (Eigen::Index k = 0; k < inverse.size(); ++k) covariance_.push_back(variance * inverse.data()[k]);
  t_ = t_quantile(static_cast<double>(n - p));
}

std::vector<double> ResponseSurface::row(const std::vector<double>& coded) const {
  std::vector<double> values;
  for (const Term& term : terms_) values.push_back(term_value(term.name, coded));
  return values;
}

double ResponseSurface::value(const std::vector<double>& coded) const {
  double sum = 0;
  for (const Term& term : terms_) sum += term.coefficient * term_value(term.name, coded);
  return sum;
}

double ResponseSurface::half_width(const std::vector<double>& coded) const {
  if (!has_confidence()) return NAN;
  const std::vector<double> x = row(coded);
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < x.size(); ++j) sum += x[i] * covariance_[i * x.size() + j] * x[j];
  return t_ * std::sqrt(sum);
}

double desirability(double value, double target, const DesirabilityShape& shape) {
  const double miss = std::abs(value - target) / (shape.half_range * std::abs(target));
  return miss < 1 ? std::pow(1 - miss, shape.exponent) : 0;
}

}  // namespace asperity::app
