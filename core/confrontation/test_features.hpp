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

/// Standard deviation of each feature from the instruments' errors of scale and zero; Eq. (N1).
std::vector<double> instrument_deviations(const Curve& curve, const MeasuredTest& test);

/// Standard deviation of each feature from the noise of the curve's rows; Eq. (N24). `specimen`: its place in the test,
/// so that no two have the same draws.
std::vector<double> noise_deviations(const Curve& curve, const MeasuredTest& test, std::size_t specimen);

}  // namespace asperity
