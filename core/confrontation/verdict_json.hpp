#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/confrontation/confront.hpp"

namespace asperity {

/// A parameter's value in its own unit, after calibration of the base.
struct ParameterValue {
  std::string name, label, unit;
  double value = 0, error = 0;
  bool determined = true, limited = false;
};

/// A further test and what it would decide.
struct NextTest {
  std::string id, description;
  std::string changes;                 ///< Id of the measured test that it is made like.
  std::vector<std::string> separates;  ///< Ids of two causes.
  double distance = 0;                 ///< D, Eq. (N18).
  double probability_correct = 0;      ///< Phi(D/2)
};

/// What a verdict says beside the confrontation's numbers.
struct VerdictContext {
  std::vector<ParameterValue> parameters;
  std::vector<ParameterValue> extended_parameters;  ///< Of the best extension, refitted with it; empty without one.
  std::vector<NextTest> next_tests;
  std::string extended_config;  ///< Relative to the verdict; empty where there is none.
  std::string data_sha256, frozen_sha256;
  std::vector<std::string> notes;  ///< E.g. a proposed split, failed runs.
};

/// verdict.json: the same bytes for the same data, configuration and code.
nlohmann::ordered_json verdict_json(const Confrontation& confrontation, const VerdictContext& context);

/// Ids of the causes that the verdict names: all kept ones, suspects of the solver first, at most five.
std::vector<std::string> verdict_causes(const Confrontation& confrontation);

/// Ids of a fit's causes, joined by " + ".
std::string causes_text(const Confrontation& confrontation, const std::vector<Eigen::Index>& causes);

}  // namespace asperity
