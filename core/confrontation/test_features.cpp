#include "core/confrontation/test_features.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

double largest(const std::vector<double>& column) {
  double most = 0.0;
  for (const double v : column) most = std::max(most, std::abs(v));
  return most;
}

void change(std::vector<double>& column, double scale, double shift) {
  for (double& v : column) v = scale * v + shift;
}

/// Length over which the path is a strain, mm; 1 where it is a displacement.
std::optional<double> path_length(const MeasuredTest& test) {
  if (!is_compression(test.experiment)) return 1.0;
  return path_is_gauge(test) ? test.axial_gauge_mm : test.height_mm;
}

/// The curve with each instrument's error put in, one at a time.
std::vector<Curve> curves_with_errors(const Curve& curve, const MeasuredTest& test) {
  constexpr double kShare = 0.01;
  const Instrument& i = test.instrument;
  std::vector<Curve> curves(3, curve);
  change(curves[0].load, 1.0 + kShare * i.load_scale_percent, 0.0);
  change(curves[1].load, 1.0, kShare * i.load_zero_percent * largest(curve.load));
  change(curves[2].path, 1.0 + kShare * i.displacement_scale_percent, 0.0);
  change(curves[2].gauge_strain, 1.0 + kShare * i.displacement_scale_percent, 0.0);
  if (const auto length = path_length(test)) {
    curves.push_back(curve);
    change(curves.back().path, 1.0, i.displacement_zero_mm / *length);
  }
  return curves;
}

void take_mean(TestFeature& feature) {
  double sum = 0.0, square = 0.0;
  for (const SpecimenValue& s : feature.specimens) {
    if (!s.value) continue;
    ++feature.count;
    sum += *s.value;
  }
  if (feature.count == 0) return;
  feature.mean = sum / feature.count;
  for (const SpecimenValue& s : feature.specimens) {
    if (s.value) square += (*s.value - feature.mean) * (*s.value - feature.mean);
  }
  if (feature.count > 1) feature.sd = std::sqrt(square / (feature.count - 1));
}

std::vector<TestFeature> without_values(ExperimentType experiment) {
  std::vector<TestFeature> features;
  for (const FeatureKind& kind : feature_kinds(experiment)) {
    features.emplace_back();
    features.back().kind = &kind;
  }
  return features;
}

void add_curve(const std::vector<FeatureValue>& values, const std::vector<double>& deviations,
               std::vector<TestFeature>& features) {
  for (std::size_t k = 0; k < features.size(); ++k) {
    features[k].specimens.push_back({values[k].value, values[k].value ? deviations[k] : 0.0, false, values[k].absent});
  }
}

/// Fills what the curves leave open.
void add_results(const MeasuredTest& test, std::size_t specimens, std::vector<TestFeature>& features) {
  for (TestFeature& feature : features) {
    const char* why =
        test.curves.empty() ? "not among the results, and there is no curve" : "no curve of this specimen";
    while (feature.specimens.size() < specimens) feature.specimens.push_back({std::nullopt, 0.0, false, why});
    const auto given = test.results.find(std::string(feature.kind->name));
    if (given == test.results.end()) continue;
    for (std::size_t i = 0; i < given->second.size(); ++i) {
      if (feature.specimens[i].value || std::isnan(given->second[i])) continue;
      feature.specimens[i] = {given->second[i], 0.0, true, ""};
    }
  }
}

}  // namespace

std::vector<double> instrument_deviations(const Curve& curve, const MeasuredTest& test) {
  const CurveReading reading = reading_of(test);
  const std::vector<FeatureValue> base = read_features(curve, reading);
  std::vector<double> square(base.size(), 0.0);
  for (const Curve& changed : curves_with_errors(curve, test)) {
    const std::vector<FeatureValue> values = read_features(changed, reading);
    for (std::size_t k = 0; k < base.size(); ++k) {
      if (base[k].value && values[k].value) square[k] += std::pow(*values[k].value - *base[k].value, 2);
    }
  }
  for (double& s : square) s = std::sqrt(s);
  return square;
}

std::vector<TestFeature> features_of(const MeasuredTest& test) {
  std::vector<TestFeature> features = without_values(test.experiment);
  const CurveReading reading = reading_of(test);
  for (const SpecimenCurve& curve : test.curves) {
    add_curve(read_features(curve.curve, reading), instrument_deviations(curve.curve, test), features);
  }
  add_results(test, specimens_of(test).size(), features);
  for (TestFeature& feature : features) take_mean(feature);
  return features;
}

std::vector<TestFeature> features_of(const Curve& curve, const CurveReading& reading) {
  std::vector<TestFeature> features = without_values(reading.experiment);
  add_curve(read_features(curve, reading), std::vector<double>(features.size(), 0.0), features);
  for (TestFeature& feature : features) take_mean(feature);
  return features;
}

}  // namespace asperity
