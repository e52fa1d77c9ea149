#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "core/measurement/curve_measures.hpp"

namespace asperity {

/// A quantity that is read off a curve, or given as a number of a test. Its name carries its unit.
struct FeatureKind {
  std::string_view name;
  std::string_view unit;      ///< "MPa", "1", ...
  std::string_view equation;  ///< Label in core/measurement/README.md.
  std::string_view what;      ///< One clause.
  FeatureValue (*value)(const CurveShape&);
};

/// The features of an experiment, in the order in which they are reported.
std::span<const FeatureKind> feature_kinds(ExperimentType experiment);

/// The kind of that name; nullptr where the experiment has none.
const FeatureKind* find_feature_kind(ExperimentType experiment, std::string_view name);

/// Values in the order of feature_kinds: the same for a measured and a simulated curve.
std::vector<FeatureValue> read_features(const Curve& curve, const CurveReading& reading);

}  // namespace asperity
