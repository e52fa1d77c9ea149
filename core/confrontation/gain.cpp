#include "core/confrontation/gain.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kTail = 0.05;  // on each side of a 90 % interval

/// Slopes by parameter, then by cause at its amplitude.
MatrixXd effects(const Comparison& comparison, const VectorXd& coded, const std::vector<Index>& causes,
                 const VectorXd& amplitude) {
  const Index parameters = comparison.jacobian.cols();
  MatrixXd columns(comparison.data.size(), parameters + static_cast<Index>(causes.size()));
  columns.leftCols(parameters) = comparison.jacobian + comparison.curvature * coded.asDiagonal();
  for (std::size_t i = 0; i < causes.size(); ++i) {
    const auto at = static_cast<Index>(i);
    columns.col(parameters + at) = slope_of(comparison, causes[i], amplitude(at));
  }
  return columns;
}

double rms(const std::vector<FeatureGain>& features, double FeatureGain::*z) {
  double sum = 0.0;
  for (const FeatureGain& f : features) sum += f.*z * f.*z;
  return features.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(features.size()));
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

std::vector<FeatureGain> feature_gains(const Comparison& comparison, const Scatter& scatter, const VectorXd& before,
                                       const VectorXd& after) {
  std::vector<FeatureGain> gains;
  for (const ComparedTest& part : comparison.tests) {
    for (std::size_t i = 0; i < part.columns.size(); ++i) {
      const Index at = part.first + static_cast<Index>(i);
      const FeatureSlot& slot = *comparison.slots[static_cast<std::size_t>(at)];
      const double sd = std::sqrt(scatter.covariance(at, at));
      gains.push_back({part.test->id, std::string(slot.kind->name), natural(slot, comparison.data(at)),
                       natural(slot, before(at)), natural(slot, after(at)), (comparison.data(at) - before(at)) / sd,
                       (comparison.data(at) - after(at)) / sd});
    }
  }
  return gains;
}

}  // namespace

double natural(const FeatureSlot& slot, double sample) { return slot.logarithmic ? std::exp(sample) : sample; }

FeaturePrediction predict_base(const Comparison& comparison, const Scatter& scatter, const BaseFit& fit) {
  const MatrixXd columns = effects(comparison, fit.coded, {}, {});
  return {model_at(comparison, fit.coded), scatter.covariance + columns * fit.covariance * columns.transpose()};
}

FeaturePrediction predict_extension(const Comparison& comparison, const Scatter& scatter, const HypothesisFit& fit) {
  const MatrixXd columns = effects(comparison, fit.coded, fit.causes, fit.amplitude);
  VectorXd mean = model_at(comparison, fit.coded);
  for (std::size_t i = 0; i < fit.causes.size(); ++i)
    mean += effect_of(comparison, fit.causes[i], fit.amplitude(static_cast<Index>(i)));
  return {std::move(mean), scatter.covariance + columns * fit.covariance * columns.transpose()};
}

double log_density(const VectorXd& data, const FeaturePrediction& prediction) {
  const Eigen::LLT<MatrixXd> factor(prediction.covariance);
  const MatrixXd lower = factor.matrixL();
  const VectorXd z = lower.triangularView<Eigen::Lower>().solve(data - prediction.mean);
  const double size = static_cast<double>(data.size());
  return -0.5 * z.squaredNorm() - lower.diagonal().array().log().sum() - 0.5 * size * std::log(2.0 * std::numbers::pi);
}

Gain measure_gain(const Comparison& hold_out, const Scatter& scatter, const FeaturePrediction& base,
                  const FeaturePrediction& extension, const GateOptions& options) {
  Gain gain;
  gain.features = feature_gains(hold_out, scatter, base.mean, extension.mean);
  gain.rms_before = rms(gain.features, &FeatureGain::z_before);
  gain.rms_after = rms(gain.features, &FeatureGain::z_after);
  gain.elpd_change = log_density(hold_out.data, extension) - log_density(hold_out.data, base);
  RandomStream random(options.seed, "confrontation gain");
  std::vector<double> changes;
  for (int d = 0; d < options.draws; ++d) {
    options.at_each_draw();
    const VectorXd data = hold_out.data + repeat(hold_out, scatter, options.noise, random).difference;
    changes.push_back(log_density(data, extension) - log_density(data, base));
  }
  gain.low = quantile(changes, kTail);
  gain.high = quantile(changes, 1.0 - kTail);
  return gain;
}

}  // namespace asperity
