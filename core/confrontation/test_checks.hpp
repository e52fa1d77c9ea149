#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/error.hpp"
#include "core/confrontation/measured_data.hpp"

/// Checks of a test that the schema cannot make. `pointer` is the test's place in the file.
namespace asperity {

/// Keys that have no meaning for the experiment, those that it cannot do without, a test with neither curve nor result.
std::vector<Fault> key_faults(const nlohmann::json& test, const std::string& pointer, ExperimentType experiment);

/// Puts the results into the test, in the core's units, and returns what is wrong with them. The test has its curves.
std::vector<Fault> take_in_results(const nlohmann::json& json, const std::string& pointer, MeasuredTest& test);

/// Specimens that are too few; strengths that are not total; a gauge longer than the specimen.
std::vector<Fault> test_faults(const MeasuredTest& test, const std::string& pointer);

/// Names that two tests share.
std::vector<Fault> id_faults(const MeasuredData& data);

}  // namespace asperity
