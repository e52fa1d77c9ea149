#pragma once
#include <string>
#include <vector>

#include "core/confrontation/measured_data.hpp"

namespace asperity {

/// Of causes that a verdict keeps, those that are known to be taken for one another, a sentence each with the test that
/// tells them apart.
std::vector<std::string> known_confusions(const std::vector<std::string>& causes, const MeasuredData& data);

}  // namespace asperity
