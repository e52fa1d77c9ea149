#include "core/confrontation/test_features.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/random.hpp"

namespace asperity {
namespace {

constexpr double kShare = 0.01;  // of a percentage
constexpr int kNoiseDraws = 24;  // a standard deviation to 15 %

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

void add_noise(std::vector<double>& column, double percent, RandomStream& random) {
  const double sd = kShare * percent * largest(column);
  for (double& v : column) v += sd * random.normal();
}

Curve with_noise(Curve curve, const Instrument& instrument, RandomStream& random) {
  const bool gauge_alone = curve.gauge_strain == curve.path;
  add_noise(curve.load, instrument.load_noise_percent, random);
  add_noise(curve.path, instrument.displacement_noise_percent, random);
  add_noise(curve.gauge_strain, instrument.displacement_noise_percent, random);
  if (gauge_alone) curve.gauge_strain = curve.path;
  for (auto* column : {&curve.lateral_strain, &curve.dilation_mm, &curve.dilation_front_mm, &curve.dilation_rear_mm})
    add_noise(*column, instrument.transverse_noise_percent, random);
  return curve;
}

/// About their mean; 0 of fewer than two.
double standard_deviation(const std::vector<double>& values) {
  if (values.size() < 2) return 0.0;
  double sum = 0.0, square = 0.0;
  for (const double v : values) sum += v;
  const double mean = sum / static_cast<double>(values.size());
  for (const double v : values) square += (v - mean) * (v - mean);
  return std::sqrt(square / static_cast<double>(values.size() - 1));
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

void add_curve(const std::vector<FeatureValue>& values, const std::vector<double>& instrument,
               const std::vector<double>& noise, std::vector<TestFeature>& features) {
  for (std::size_t k = 0; k < features.size(); ++k) {
    const bool there = values[k].value.has_value();
    features[k].specimens.push_back(
        {values[k].value, there ? instrument[k] : 0.0, there ? noise[k] : 0.0, false, values[k].absent});
  }
}

/// Fills what the curves leave open.
void add_results(const MeasuredTest& test, std::size_t specimens, std::vector<TestFeature>& features) {
  for (TestFeature& feature : features) {
    const char* why =
        test.curves.empty() ? "not among the results, and there is no curve" : "no curve of this specimen";
    while (feature.specimens.size() < specimens) feature.specimens.push_back({std::nullopt, 0.0, 0.0, false, why});
    const auto given = test.results.find(std::string(feature.kind->name));
    if (given == test.results.end()) continue;
    for (std::size_t i = 0; i < given->second.size(); ++i) {
      if (feature.specimens[i].value || std::isnan(given->second[i])) continue;
      feature.specimens[i] = {given->second[i], 0.0, 0.0, true, ""};
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

std::vector<double> noise_deviations(const Curve& curve, const MeasuredTest& test, std::size_t specimen) {
  const CurveReading reading = reading_of(test);
  RandomStream random(specimen, "noise of rows");
  std::vector<std::vector<double>> values(feature_kinds(test.experiment).size());
  for (int d = 0; d < kNoiseDraws; ++d) {
    const std::vector<FeatureValue> drawn = read_features(with_noise(curve, test.instrument, random), reading);
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (drawn[k].value) values[k].push_back(*drawn[k].value);
    }
  }
  std::vector<double> deviations;
  for (const std::vector<double>& v : values) deviations.push_back(standard_deviation(v));
  return deviations;
}

std::vector<TestFeature> features_of(const MeasuredTest& test) {
  std::vector<TestFeature> features = without_values(test.experiment);
  const CurveReading reading = reading_of(test);
  for (std::size_t i = 0; i < test.curves.size(); ++i) {
    const Curve& curve = test.curves[i].curve;
    add_curve(read_features(curve, reading), instrument_deviations(curve, test), noise_deviations(curve, test, i),
              features);
  }
  add_results(test, specimens_of(test).size(), features);
  for (TestFeature& feature : features) take_mean(feature);
  return features;
}

std::vector<TestFeature> features_of(const Curve& curve, const CurveReading& reading) {
  std::vector<TestFeature> features = without_values(reading.experiment);
  const std::vector<double> exact(features.size(), 0.0);
  add_curve(read_features(curve, reading), exact, exact, features);
  for (TestFeature& feature : features) take_mean(feature);
  return features;
}

}  // namespace asperity
