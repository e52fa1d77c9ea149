#include "core/confrontation/confrontation_parameter.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/units.hpp"
#include "core/confrontation/significant_digits.hpp"

namespace asperity {
namespace {

constexpr int kValueDigits = 12;

double exact_value(ParameterTransform transform, double theta) {
  switch (transform) {
    case ParameterTransform::log:
      return std::exp(theta);
    case ParameterTransform::tangent:
      return std::atan(theta) / units::kRadPerDeg;
    case ParameterTransform::linear:
      break;
  }
  return theta;
}

}  // namespace

double theta_of(ParameterTransform transform, double value) {
  switch (transform) {
    case ParameterTransform::log:
      return std::log(value);
    case ParameterTransform::tangent:
      return std::tan(value * units::kRadPerDeg);
    case ParameterTransform::linear:
      break;
  }
  return value;
}

double value_of(ParameterTransform transform, double theta) {
  return rounded_to(exact_value(transform, theta), kValueDigits);
}

bool acts_in(const ConfrontationParameter& parameter, ExperimentType experiment) {
  return std::find(parameter.only.begin(), parameter.only.end(), experiment) != parameter.only.end();
}

std::vector<double> reference_theta(const std::vector<ConfrontationParameter>& parameters) {
  std::vector<double> theta;
  for (const ConfrontationParameter& p : parameters) theta.push_back(theta_of(p.transform, p.reference));
  return theta;
}

}  // namespace asperity
