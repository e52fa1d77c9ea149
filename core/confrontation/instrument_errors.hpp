#pragma once
#include <Eigen/Core>
#include <vector>

#include "core/confrontation/evidence.hpp"
#include "core/confrontation/test_features.hpp"

namespace asperity {

/// What a test's instruments may be off, in the unit that features are compared in.
struct MeasuredErrors {
  /// Rows: independent errors of one standard deviation; columns: what each changes the specimens' mean of a slot by.
  /// Eqs. (N1, N24): scales are the same for all specimens, zeros and rows' noise each specimen's own. A load scale
  /// changes a strength and a modulus of one test together, so features of a test are off together.
  Eigen::MatrixXd of_mean;
  Eigen::VectorXd own_sd;  ///< Of one specimen, by its own zeros and rows.
};

/// `features`: of the test, slot by slot.
MeasuredErrors measured_errors(const std::vector<FeatureSlot>& slots, const std::vector<const TestFeature*>& features,
                               const MeasuredTest& test);

}  // namespace asperity
