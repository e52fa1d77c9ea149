#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/calibration/target.hpp"

namespace asperity {

/// One property of the calibrated model on n fresh meshes.
struct Verification {
  std::string property;
  double target = 0, tolerance = 0;
  std::vector<double> values;       ///< One a mesh.
  double mean = 0, sd = 0;          ///< Eq. (S29); the sd of a single mesh, with n - 1; NaN for one mesh.
  double bias = 0;                  ///< Eq. (S30), relative.
  bool within = false;              ///< |bias| <= tolerance.
  std::optional<double> predicted;  ///< What the fitted model said before.
};

/// Throws Error(config) naming the property where there is no value.
Verification verify(const Target& target, std::vector<double> values, std::optional<double> predicted);

}  // namespace asperity
