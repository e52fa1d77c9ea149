#include "core/confrontation/feature_rules.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "core/config/enum_words.hpp"
#include "core/measurement/features.hpp"

using namespace asperity;

TEST_CASE("every declared feature can be read, has a floor and a reason for it, and stands once") {
  for (const auto& [type, name] : words_of(ExperimentType{})) {
    std::set<std::string_view> seen;
    for (const FeatureRule& rule : feature_rules(type)) {
      CAPTURE(std::string(name), std::string(rule.name));
      CHECK(find_feature_kind(type, rule.name) != nullptr);
      CHECK(find_feature_rule(type, rule.name) == &rule);
      CHECK(seen.insert(rule.name).second);
      CHECK(rule.floor > 0.0);
      CHECK(rule.floor < 0.2);
      CHECK(rule.why.size() > 10);
      CHECK_FALSE((rule.logarithmic && rule.unit != FloorUnit::feature));
    }
  }
  CHECK(find_feature_rule(ExperimentType::uniaxial, "residual_axial_stress_mpa") == nullptr);
  CHECK(find_feature_rule(ExperimentType::triaxial, "residual_axial_stress_mpa") != nullptr);
}

TEST_CASE("the unit of a length's floor is that of its feature") {
  for (const auto& [type, name] : words_of(ExperimentType{})) {
    for (const FeatureRule& rule : feature_rules(type)) {
      CAPTURE(std::string(rule.name));
      const std::string_view unit = find_feature_kind(type, rule.name)->unit;
      if (rule.unit == FloorUnit::length) CHECK(unit == "mm");
      if (rule.unit == FloorUnit::strain) CHECK(unit == "1");
      if (!rule.logarithmic && rule.unit == FloorUnit::feature) CHECK(unit == "1");
    }
  }
}

TEST_CASE("the floor of a strain is five micrometres over the specimen's height") {
  RunConfig test;
  test.experiment.height_mm = 100.0;
  CHECK(floor_of(*find_feature_rule(ExperimentType::uniaxial, "toe_travel_strain"), test) == Approx(5e-5));
  CHECK(floor_of(*find_feature_rule(ExperimentType::brazilian, "toe_travel_mm"), test) == 0.005);
  CHECK(floor_of(*find_feature_rule(ExperimentType::uniaxial, "peak_axial_stress_mpa"), test) == 0.01);
}
