#pragma once
#include <filesystem>
#include <string_view>
#include <vector>

#include "core/base/error.hpp"
#include "core/confrontation/measured_data.hpp"
#include "core/output/csv.hpp"

namespace asperity {

/// Splits a table into the curves of its specimens, in the core's units, and puts them into the test. Returns what is
/// wrong with its columns, cells and specimens, at file or file:line; then the test's curves stay empty.
std::vector<Fault> take_in_curves(const CsvData& table, const std::filesystem::path& name, MeasuredTest& test);

/// What cannot be a curve of the test: numbers that are none or too large, too few rows, ways back without a reload, a
/// peak at the end, wrong signs or units, counts that fall, stresses that are not total.
std::vector<Fault> curve_faults(const MeasuredTest& test);

}  // namespace asperity
