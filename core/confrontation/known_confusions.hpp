#pragma once
#include <string>
#include <vector>

#include "core/confrontation/measured_data.hpp"

namespace asperity {

/// Mechanisms for which this one was named wrongly in laboratories with a known cause, or that were named for it: a
/// better fit does not tell them apart, Eq. (N25). Without those for which the laboratory made the test that does.
std::vector<std::string> doubles_of(const std::string& id, const MeasuredData& data);

/// Those for which it made that test.
std::vector<std::string> tested_doubles_of(const std::string& id, const MeasuredData& data);

/// Whether the laboratory made that further test, and does not keep it back; false of those that part no doubles.
bool is_made(const std::string& design, const MeasuredData& data);

/// Whether that further test is one that tells these doubles apart.
bool decides(const std::string& design, const std::string& one, const std::string& other);

/// Of causes that a verdict keeps, those that are known to be taken for one another, a sentence each with the test that
/// tells them apart.
std::vector<std::string> known_confusions(const std::vector<std::string>& causes, const MeasuredData& data);

}  // namespace asperity
