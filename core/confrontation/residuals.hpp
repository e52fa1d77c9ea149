#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "core/confrontation/scatter.hpp"
#include "core/confrontation/whitened.hpp"

namespace asperity {

/// One feature of a fitted test against the calibrated base.
struct FeatureResidual {
  std::string test, feature;
  double measured = 0, simulated = 0;  ///< In the feature's own unit.
  double z = 0;                        ///< Difference over its standard deviation.
  double percent = 0;                  ///< Measured over simulated, less one; NaN where the simulated value is 0.
  double simulated_left_out = NAN;     ///< After calibration without this test; NaN where this test alone determines
                                       ///< a parameter, or no other one is left.
  double z_left_out = NAN;             ///< Likewise, with what is then not known of the parameters.
};

/// In the order of the slots. Leave-one-test-out: each test predicted from the others.
std::vector<FeatureResidual> feature_residuals(const Comparison& comparison, const Scatter& scatter, const BaseFit& fit,
                                               const std::vector<CalibratedParameter>& parameters);

}  // namespace asperity
