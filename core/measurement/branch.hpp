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
  std::size_t smoothing_rows = 0;
};

/// Smooths over `rows` rows, Eq. (F2); 0: the rows as they are.
Branch make_branch(std::vector<double> path, std::vector<double> load, std::size_t rows);

/// Values of the line through the last `rows` + 1 rows up to each row, at that row; Eq. (F4). The first rows, which
/// have not as many before them, keep their values. 0: the values as they are.
std::vector<double> trailing_values(std::span<const double> values, std::size_t rows);

/// Where the smoothed load reaches a level.
struct Crossing {
  double path = 0;
  std::size_t row = 0;  ///< The first row beyond.
  double share = 1;     ///< Of the step from the row before to this one.
};
enum class Direction { rising, falling };

/// Where the smoothed load first reaches a level at or after row `begin`, by linear interpolation; empty where it does
/// not before row `end`. Where noise crosses it several times, the row that parts them best; Eq. (F26).
std::optional<Crossing> find_crossing(const Branch& branch, double level, Direction direction, std::size_t begin,
                                      std::size_t end);

/// The row that best parts rows of which something does not hold from those of which it does: before it as many as
/// possible do not, from it on as many as possible do; Eq. (F26). `holds.size()` where it holds of none.
std::size_t parting_row(const std::vector<bool>& holds);

/// Smoothed load at a path at or after row `begin`; empty where the branch does not get there.
std::optional<double> load_at(const Branch& branch, double path, std::size_t begin);

/// The path as a line over the load in a window of loads, over rows before `end`: slope is the compliance, Eq. (F3),
/// intercept the path at no load. Empty for fewer than three rows or a line that does not rise.
std::optional<Line> compliance_line(const Branch& branch, std::size_t end, double low, double high);

}  // namespace asperity
