#include "core/confrontation/residuals.hpp"

#include <cmath>
#include <optional>

#include "core/confrontation/gain.hpp"

namespace asperity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::vector<Index> all_but(const Comparison& comparison, const ComparedTest& out) {
  std::vector<Index> kept;
  const Index size = static_cast<Index>(out.columns.size());
  for (Index i = 0; i < comparison.data.size(); ++i) {
    if (i < out.first || i >= out.first + size) kept.push_back(i);
  }
  return kept;
}

/// What calibration reads of a comparison, for some of its slots.
Comparison restricted(const Comparison& comparison, const std::vector<Index>& kept) {
  Comparison part;
  part.data = comparison.data(kept);
  part.model = comparison.model(kept);
  part.jacobian = comparison.jacobian(kept, Eigen::all);
  part.curvature = comparison.curvature(kept, Eigen::all);
  return part;
}

/// The test by the others' calibration; nothing where they leave a parameter open that it alone determines.
std::optional<FeaturePrediction> predicted_by_others(const Comparison& comparison, const Scatter& scatter,
                                                     const BaseFit& fit,
                                                     const std::vector<CalibratedParameter>& parameters,
                                                     const ComparedTest& part) {
  const std::vector<Index> kept = all_but(comparison, part);
  if (kept.empty()) return std::nullopt;
  const BaseFit without = calibrate_base(restricted(comparison, kept), scatter.covariance(kept, kept), parameters);
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    if (fit.determined[p] && !without.determined[p]) return std::nullopt;
  }
  return predict_base(comparison, scatter, without);
}

}  // namespace

std::vector<FeatureResidual> feature_residuals(const Comparison& comparison, const Scatter& scatter, const BaseFit& fit,
                                               const std::vector<CalibratedParameter>& parameters) {
  std::vector<FeatureResidual> residuals;
  for (const ComparedTest& part : comparison.tests) {
    const std::optional<FeaturePrediction> left_out = predicted_by_others(comparison, scatter, fit, parameters, part);
    for (std::size_t i = 0; i < part.columns.size(); ++i) {
      const Index at = part.first + static_cast<Index>(i);
      const FeatureSlot& slot = *comparison.slots[static_cast<std::size_t>(at)];
      FeatureResidual r{part.test->id, std::string(slot.kind->name)};
      r.measured = natural(slot, comparison.data(at));
      r.simulated = natural(slot, comparison.data(at) - fit.difference(at));
      r.z = fit.difference(at) / std::sqrt(scatter.covariance(at, at));
      r.percent = r.simulated != 0.0 ? 100.0 * (r.measured / r.simulated - 1.0) : NAN;
      if (left_out) {
        r.simulated_left_out = natural(slot, left_out->mean(at));
        r.z_left_out = (comparison.data(at) - left_out->mean(at)) / std::sqrt(left_out->covariance(at, at));
      }
      residuals.push_back(std::move(r));
    }
  }
  return residuals;
}

}  // namespace asperity
