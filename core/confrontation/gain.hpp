#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/confrontation/naming.hpp"

namespace asperity {

/// What a model says of the compared slots before it sees their data.
struct FeaturePrediction {
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;  ///< Of data less mean: scatter, and what is not known of parameters and amplitudes.
};

/// The base at its calibration, from effects on common meshes.
FeaturePrediction predict_base(const Comparison& comparison, const Scatter& scatter, const BaseFit& fit);

/// An extension at its refitted parameters and amplitudes, likewise.
FeaturePrediction predict_extension(const Comparison& comparison, const Scatter& scatter, const HypothesisFit& fit);

/// Logarithm of the normal density of the data, Eq. (N17).
double log_density(const Eigen::VectorXd& data, const FeaturePrediction& prediction);

/// One kept-back feature before and after.
struct FeatureGain {
  std::string test, feature;
  double measured = 0, before = 0, after = 0;  ///< In the feature's own unit.
  double z_before = 0, z_after = 0;            ///< Over the scatter of the difference alone, the same for both.
};

/// How much better an extension predicts tests that nothing was fitted to.
struct Gain {
  std::string id;                        ///< Of its causes, joined by " + ".
  double elpd_change = 0;                ///< Difference of log densities, extension less base; Eq. (N17).
  double low = 0, high = 0;              ///< 90 % of repetitions.
  double rms_before = 0, rms_after = 0;  ///< Root mean square of z.
  std::vector<FeatureGain> features;
  bool claimed() const { return low > 0.0; }
};

Gain measure_gain(const Comparison& hold_out, const Scatter& scatter, const FeaturePrediction& base,
                  const FeaturePrediction& extension, const GateOptions& options);

/// A feature's value in its own unit.
double natural(const FeatureSlot& slot, double sample);

}  // namespace asperity
