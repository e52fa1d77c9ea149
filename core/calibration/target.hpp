#pragma once
#include <string>

namespace asperity {

/// A laboratory figure that the model shall show.
struct Target {
  std::string property;  ///< "tensile_strength_mpa", ...
  double value = 0;
  double tolerance = 0.05;    ///< Relative: met within tolerance |value|.
  double standard_error = 0;  ///< Of the laboratory's mean, in the property's unit; 0 where it counts as exact.
  double weight = 1;          ///< Of its desirability in the overall one.
};

}  // namespace asperity
