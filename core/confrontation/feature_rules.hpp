#pragma once
#include <span>
#include <string_view>

#include "core/config/run_config.hpp"

namespace asperity {

/// What a feature's floor is a length over.
enum class FloorUnit {
  feature,  ///< Nothing: it is in the unit of the compared number.
  length,   ///< Nothing: mm.
  strain    ///< The specimen's height: mm.
};

/// How a confrontation compares one feature.
struct FeatureRule {
  std::string_view name;
  bool logarithmic = false;  ///< Its logarithm is compared: positive by nature.
  double floor = 0;          ///< Least standard deviation of one specimen that is believed.
  FloorUnit unit = FloorUnit::feature;
  std::string_view why;  ///< Of the floor.
};

/// The declared list of an experiment.
std::span<const FeatureRule> feature_rules(ExperimentType experiment);

/// The rule of that name; nullptr where the experiment has none.
const FeatureRule* find_feature_rule(ExperimentType experiment, std::string_view name);

/// The floor in the unit of the compared number, for this virtual test.
double floor_of(const FeatureRule& rule, const RunConfig& test);

}  // namespace asperity
