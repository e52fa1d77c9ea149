#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace asperity {

/// Least-squares line y = intercept + slope x.
struct Line {
  double slope = 0, intercept = 0;
  double at(double x) const { return intercept + slope * x; }
};

/// Needs two different x.
Line fit_line(std::span<const double> x, std::span<const double> y);

/// Rows before `end` whose load lies in [low, high], in order.
std::vector<std::size_t> window_rows(std::span<const double> load, std::size_t end, double low, double high);

/// The values at some rows.
std::vector<double> gather(std::span<const double> values, std::span<const std::size_t> rows);

/// Slope of y over x with the order of the rows as instrument: cov(row, y) / cov(row, x). Noise of x does not flatten
/// it, as it flattens a least-squares slope; Eq. (F3). Zero for fewer than three rows or an x that does not change.
double slope_in_order(std::span<const double> x, std::span<const double> y);

}  // namespace asperity
