#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/confrontation/measured_data.hpp"
#include "core/measurement/features.hpp"

namespace asperity {

/// One feature of one specimen.
struct SpecimenValue {
  std::optional<double> value;
  double instrument_sd = 0;   ///< From errors of scale and zero, Eq. (N1); 0 of a result and of a simulation.
  double scale_sd = 0;        ///< From those of scale alone, which all specimens of a test share; 0 likewise.
  double noise_sd = 0;        ///< From the noise of single rows, Eq. (N24); 0 likewise.
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

}  // namespace asperity
