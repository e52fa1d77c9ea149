#pragma once
#include <string>
#include <utility>
#include <vector>

namespace asperity::app {

/// A term of a quadratic model by its name: "1", "x1", "x1x2", "x1^2"; factors from 1. Its value at coded levels.
/// Throws Error(config) for a name that is no such term of these factors.
double term_value(const std::string& term, const std::vector<double>& coded);

/// A fitted quadratic in coded factors, and how sure it is.
class ResponseSurface {
 public:
  struct Term {
    std::string name;
    double coefficient = 0;
    double standard_error = 0;
  };

  /// `runs`: coded levels of the runs that the model was fitted to.
  ResponseSurface(std::vector<Term> terms, const std::vector<std::vector<double>>& runs);

  /// The response at coded levels, in its unit.
  double value(const std::vector<double>& coded) const;

  /// Half the width of the 95 % confidence interval of the mean response, t s sqrt(x (X'X)^-1 x'). NaN where the runs
  /// do not tell it, and below five degrees of freedom, where the expansion of t used here is off by more than 0.1 %.
  double half_width(const std::vector<double>& coded) const;

  bool has_confidence() const { return t_ > 0; }

 private:
  std::vector<double> row(const std::vector<double>& coded) const;
  std::vector<Term> terms_;
  std::vector<double> covariance_;  ///< Of the coefficients, terms by terms.
  double t_ = 0;                    ///< 97.5 % quantile of Student's t; 0 where unknown.
};

/// Target-is-best desirability of a value (Derringer & Suich 1980): 1 on the target, falling as
/// (1 - |value - target| / (half_range |target|))^exponent to 0.
struct DesirabilityShape {
  double half_range = 0.25;
  double exponent = 1;
};
double desirability(double value, double target, const DesirabilityShape& shape);

}  // namespace asperity::app
