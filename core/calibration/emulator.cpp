#include "core/calibration/emulator.hpp"

#include <algorithm>
#include <cmath>
#include <openturns/KrigingAlgorithm.hxx>
#include <openturns/LinearBasisFactory.hxx>
#include <openturns/MaternModel.hxx>
#include <openturns/ResourceMap.hxx>

#include "core/base/error.hpp"
#include "core/calibration/silence.hpp"

namespace asperity {

struct Emulator::Fitted {
  OT::KrigingResult kriging;
  double centre = 0, scale = 1;  ///< The values are fitted as (y - centre) / scale.
};

namespace {

constexpr double kDifference = 1e-4;  // coded: the Matern 5/2 mean is twice differentiable, so the error is near 1e-8
constexpr double kShortest =
    0.7;  // coded length scale: shorter, and neighbouring runs would tell nothing of each other
constexpr double kLongest = 20.0;  // coded length scale: a plane over the whole design
constexpr double kMatern = 2.5;
constexpr double kLeastAmplitude = 0.01;  // of half the values' range: the trend is all there is
constexpr double kMostAmplitude = 100.0;  // of half the values' range
// Of half the values' range: far below any mesh scatter. With less, repeated runs make the likelihood so steep that the
// search for it stays where it starts.
constexpr double kLeastNoise = 1e-3;

/// Left to itself OpenTURNS 1.20 finds the amplitude in closed form, as if the noise grew with it: the stated variance
/// would be taken as a share of the amplitude's square. While this lives the amplitude is one more parameter to search
/// for, and the noise is what is stated.
class SearchedAmplitude {
 public:
  SearchedAmplitude() : before_(OT::ResourceMap::GetAsBool(kKey)) { OT::ResourceMap::SetAsBool(kKey, false); }
  ~SearchedAmplitude() { OT::ResourceMap::SetAsBool(kKey, before_); }
  SearchedAmplitude(const SearchedAmplitude&) = delete;
  SearchedAmplitude& operator=(const SearchedAmplitude&) = delete;

 private:
  static constexpr const char* kKey = "GeneralLinearModelAlgorithm-UseAnalyticalAmplitudeEstimate";
  bool before_;
};

OT::Point point_of(const std::vector<double>& values) {
  OT::Point point(values.size());
  std::copy(values.begin(), values.end(), point.begin());
  return point;
}

OT::Sample sample_of(const std::vector<std::vector<double>>& rows) {
  OT::Sample sample(0, rows.front().size());
  for (const std::vector<double>& row : rows) sample.add(point_of(row));
  return sample;
}

/// Middle and half width of the values' range; a width of 1 where they are all the same.
std::pair<double, double> spread_of(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double half = 0.5 * (*high - *low);
  return {0.5 * (*high + *low), half > 0.0 ? half : 1.0};
}

/// Eq. (S31), the noise at its stated variance; Eq. (S32) fitted.
OT::KrigingResult krige(const OT::Sample& inputs, const OT::Sample& outputs, double noise_variance) {
  const std::size_t k = inputs.getDimension();
  const SearchedAmplitude searched;
  OT::Point lowest(k, kShortest), highest(k, kLongest);
  lowest.add(kLeastAmplitude);
  highest.add(kMostAmplitude);
  OT::KrigingAlgorithm algorithm(inputs, outputs, OT::MaternModel(OT::Point(k, 1.0), OT::Point(1, 1.0), kMatern),
                                 OT::LinearBasisFactory(k).build());
  algorithm.setNoise(OT::Point(inputs.getSize(), noise_variance));
  algorithm.setOptimizationBounds(OT::Interval(lowest, highest));
  algorithm.run();
  return algorithm.getResult();
}

}  // namespace

Emulator::Emulator(const std::vector<std::vector<double>>& x, const std::vector<double>& y, double noise_sd)
    : fitted_(std::make_unique<Fitted>()) {
  std::tie(fitted_->centre, fitted_->scale) = spread_of(y);
  OT::Sample outputs(y.size(), 1);
  for (std::size_t i = 0; i < y.size(); ++i) outputs(i, 0) = (y[i] - fitted_->centre) / fitted_->scale;
  const double noise = std::max(noise_sd / fitted_->scale, kLeastNoise);
  const Silence silence;
  try {
    fitted_->kriging = krige(sample_of(x), outputs, noise * noise);
  } catch (const OT::Exception& failure) {
    throw Error(ErrorKind::numerical, std::string("the kriging emulator cannot be fitted: ") + failure.what());
  }
}

Emulator::~Emulator() = default;
Emulator::Emulator(Emulator&&) noexcept = default;
Emulator& Emulator::operator=(Emulator&&) noexcept = default;

double Emulator::mean(const std::vector<double>& x) const {
  return fitted_->centre + fitted_->scale * fitted_->kriging.getConditionalMean(point_of(x))[0];
}

double Emulator::variance(const std::vector<double>& x) const {
  const double relative = fitted_->kriging.getConditionalMarginalVariance(point_of(x));
  return std::max(relative, 0.0) * fitted_->scale * fitted_->scale;
}

std::vector<double> Emulator::gradient(const std::vector<double>& x) const {
  std::vector<double> gradient(x.size());
  for (std::size_t j = 0; j < x.size(); ++j) {
    std::vector<double> above = x, below = x;
    above[j] += kDifference;
    below[j] -= kDifference;
    gradient[j] = (mean(above) - mean(below)) / (2.0 * kDifference);
  }
  return gradient;
}

}  // namespace asperity
