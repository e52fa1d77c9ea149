#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/measurement/line_fit.hpp"

namespace asperity {

/// A stretch of a curve in one direction: load above the base over the path, as recorded and smoothed.
struct Branch {
  std::vector<double> path, load;
  std::vector<double> smooth_path, smooth_load;
};

/// Smooths over `rows` rows, Eq. (F2); 0: the rows as they are.
Branch make_branch(std::vector<double> path, std::vector<double> load, std::size_t rows);

/// Values of the line through the last `rows` + 1 rows up to each row, at that row; Eq. (F4). The first rows, which have
/// not as many before them, keep their values. 0: the values as they are.
std::vector<double> trailing_values(std::span<const double> values, std::size_t rows);

/// Path where the smoothed load first reaches a level at or after row `begin`, rising or falling, by linear
/// interpolation; empty where it does not before row `end`.
struct Crossing {
  double path = 0;
  std::size_t row = 0;  ///< The first row beyond.
};
enum class Direction { rising, falling };
std::optional<Crossing> find_crossing(const Branch& branch, double level, Direction direction, std::size_t begin,
                                      std::size_t end);

/// Smoothed load at a path at or after row `begin`; empty where the branch does not get there.
std::optional<double> load_at(const Branch& branch, double path, std::size_t begin);

/// The path as a line over the load in a window of loads, over rows before `end`: slope is the compliance, intercept the
/// path at no load. Empty for fewer than three rows or a line that does not rise.
std::optional<Line> compliance_line(const Branch& branch, std::size_t end, double low, double high);

}  // namespace asperity
