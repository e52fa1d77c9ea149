#include "core/confrontation/test_features.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/random.hpp"

namespace asperity {
namespace {

constexpr double kShare = 0.01;     // of a percentage
constexpr std::size_t kScales = 2;  // errors of scale: of load and path
constexpr int kNoiseDraws = 24;     // a standard deviation to 15 %

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

/// The curve with each instrument's error put in, one at a time: the two of scale first.
std::vector<Curve> curves_with_errors(const Curve& curve, const MeasuredTest& test) {
  const Instrument& i = test.instrument;
  std::vector<Curve> curves(3, curve);
  change(curves[0].load, 1.0 + kShare * i.load_scale_percent, 0.0);
  change(curves[1].path, 1.0 + kShare * i.displacement_scale_percent, 0.0);
  change(curves[1].gauge_strain, 1.0 + kShare * i.displacement_scale_percent, 0.0);
  change(curves[2].load, 1.0, kShare * i.load_zero_percent * largest(curve.load));
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

/// `specimen`: its place in the test, so that no two have the same draws.
std::vector<Curve> curves_with_noise(const Curve& curve, const MeasuredTest& test, std::size_t specimen) {
  RandomStream random(specimen, "noise of rows");
  std::vector<Curve> curves;
  for (int d = 0; d < kNoiseDraws; ++d) curves.push_back(with_noise(curve, test.instrument, random));
  return curves;
}

using Features = std::vector<FeatureValue>;

std::vector<Features> read_all(const std::vector<Curve>& curves, const CurveReading& reading) {
  std::vector<Features> all;
  for (const Curve& curve : curves) all.push_back(read_features(curve, reading));
  return all;
}

/// Of feature `k` over the curves that give it; 0 of fewer than two.
double standard_deviation(const std::vector<Features>& drawn, std::size_t k) {
  double count = 0.0, sum = 0.0, square = 0.0;
  for (const Features& features : drawn) {
    count += features[k].value ? 1.0 : 0.0;
    sum += features[k].value.value_or(0.0);
  }
  if (count < 2.0) return 0.0;
  for (const Features& features : drawn) {
    if (features[k].value) square += std::pow(*features[k].value - sum / count, 2);
  }
  return std::sqrt(square / (count - 1.0));
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

/// Root of the sum of squares of what the first so many curves change a feature by.
double deviation(const std::vector<Features>& changed, std::size_t curves, std::size_t k, double from) {
  double square = 0.0;
  for (std::size_t c = 0; c < curves; ++c) {
    if (changed[c][k].value) square += std::pow(*changed[c][k].value - from, 2);
  }
  return std::sqrt(square);
}

void add_curve(const MeasuredTest& test, std::size_t specimen, std::vector<TestFeature>& features) {
  const CurveReading reading = reading_of(test);
  const Curve& curve = test.curves[specimen].curve;
  const Features values = read_features(curve, reading);
  const std::vector<Features> changed = read_all(curves_with_errors(curve, test), reading),
                              noisy = read_all(curves_with_noise(curve, test, specimen), reading);
  for (std::size_t k = 0; k < features.size(); ++k) {
    SpecimenValue specimen_value{values[k].value, 0.0, 0.0, 0.0, false, values[k].absent};
    if (values[k].value) {
      specimen_value.instrument_sd = deviation(changed, changed.size(), k, *values[k].value);
      specimen_value.scale_sd = deviation(changed, kScales, k, *values[k].value);
      specimen_value.noise_sd = standard_deviation(noisy, k);
    }
    features[k].specimens.push_back(std::move(specimen_value));
  }
}

/// Fills what the curves leave open.
void add_results(const MeasuredTest& test, std::size_t specimens, std::vector<TestFeature>& features) {
  for (TestFeature& feature : features) {
    const char* why =
        test.curves.empty() ? "not among the results, and there is no curve" : "no curve of this specimen";
    while (feature.specimens.size() < specimens) feature.specimens.push_back({std::nullopt, 0.0, 0.0, 0.0, false, why});
    const auto given = test.results.find(std::string(feature.kind->name));
    if (given == test.results.end()) continue;
    for (std::size_t i = 0; i < given->second.size(); ++i) {
      if (feature.specimens[i].value || std::isnan(given->second[i])) continue;
      feature.specimens[i] = {given->second[i], 0.0, 0.0, 0.0, true, ""};
    }
  }
}

}  // namespace

std::vector<TestFeature> features_of(const MeasuredTest& test) {
  std::vector<TestFeature> features = without_values(test.experiment);
  for (std::size_t i = 0; i < test.curves.size(); ++i) add_curve(test, i, features);
  add_results(test, specimens_of(test).size(), features);
  for (TestFeature& feature : features) take_mean(feature);
  return features;
}

std::vector<TestFeature> features_of(const Curve& curve, const CurveReading& reading) {
  std::vector<TestFeature> features = without_values(reading.experiment);
  const Features values = read_features(curve, reading);
  for (std::size_t k = 0; k < features.size(); ++k)
    features[k].specimens.push_back({values[k].value, 0.0, 0.0, 0.0, false, values[k].absent});
  for (TestFeature& feature : features) take_mean(feature);
  return features;
}

}  // namespace asperity
