#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "core/config/run_config.hpp"

namespace asperity {

/// How a microparameter's value stands for theta, in which responses are taken as linear.
enum class ParameterTransform {
  log,      ///< theta = ln(value).
  tangent,  ///< theta = tan(value), value in degrees.
  linear    ///< theta = value.
};

/// A microparameter that calibration may move.
struct ConfrontationParameter {
  std::string name, label, unit;
  std::string pointer;            ///< Of the run configuration.
  std::vector<std::string> tied;  ///< Pointers that keep their proportion to the value.
  ParameterTransform transform = ParameterTransform::log;
  double step = 0;                   ///< In theta: of finite differences and of designs.
  double lower = 0, upper = 0;       ///< Of the value, both allowed.
  std::vector<ExperimentType> only;  ///< Experiments in which it acts.
  double reference = 0;              ///< Value in the bases.
  bool calibrated = true;            ///< False: stays at its reference.
};

double theta_of(ParameterTransform transform, double value);

/// Inverse of theta_of to 12 significant digits, so that another machine's last digit makes no other run of it.
double value_of(ParameterTransform transform, double theta);

/// Whether it acts in the experiment.
bool acts_in(const ConfrontationParameter& parameter, ExperimentType experiment);

/// Theta of the bases, parameter by parameter.
std::vector<double> reference_theta(const std::vector<ConfrontationParameter>& parameters);

}  // namespace asperity
