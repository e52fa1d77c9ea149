#pragma once
#include <cstddef>
#include <vector>

namespace asperity {

/// Rows that draw the same line: the least and the largest value of each of so many stretches, the first row and the
/// last.
std::vector<std::size_t> telling_rows(const std::vector<double>& values, std::size_t stretches);

}  // namespace asperity
