#pragma once
#include <string>
#include <vector>

#include "core/confrontation/measured_data.hpp"

namespace asperity {

/// Mechanisms for which this one was named wrongly in laboratories with a known cause, or that were named for it: a
/// better fit does not tell them apart, Eq. (N25).
std::vector<std::string> doubles_of(const std::string& id);

/// Of causes that a verdict keeps, those that are known to be taken for one another, a sentence each with the test that
/// tells them apart.
std::vector<std::string> known_confusions(const std::vector<std::string>& causes, const MeasuredData& data);

}  // namespace asperity
