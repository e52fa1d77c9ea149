#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/confrontation/measured_data.hpp"
#include "core/measurement/features.hpp"

namespace asperity {

/// What errors of one standard deviation change a feature by, each by itself; empty of a result and of a simulation.
struct InstrumentErrors {
  std::vector<double> scales;  ///< Of load and path, Eq. (N1): all specimens of a test have the same.
  std::vector<double> zeros;   ///< Of load and path, Eq. (N1): each specimen has its own.
  std::vector<double> noise;   ///< Draws of the rows' noise, Eq. (N24), whose squares' sum is its variance.
};

/// One feature of one specimen.
struct SpecimenValue {
  std::optional<double> value;
  InstrumentErrors errors;
  bool from_results = false;  ///< The laboratory's own number: the curve does not give one.
  std::string absent;         ///< Why there is no value.
};

/// One feature over the specimens of a test, with their mean and standard deviation.
struct TestFeature {
  const FeatureKind* kind = nullptr;
  std::vector<SpecimenValue> specimens;
  int count = 0;            ///< Of values.
  double mean = 0, sd = 0;  ///< sd 0 for fewer than two values.
};

/// All features of a test, in the order of feature_kinds; a curve's value goes before a result's.
std::vector<TestFeature> features_of(const MeasuredTest& test);

/// The same of one curve, e.g. a simulated one.
std::vector<TestFeature> features_of(const Curve& curve, const CurveReading& reading);

/// Standard deviation by errors of scale and zero; Eq. (N1).
double instrument_sd(const InstrumentErrors& errors);

/// Standard deviation by the noise of single rows; Eq. (N24).
double noise_sd(const InstrumentErrors& errors);

}  // namespace asperity
