#include "core/measurement/curve_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace asperity {
namespace {

/// Noise that may be left of a smoothed load, over the peak.
constexpr double kNoiseLeft = 0.002;
/// Smoothing reaches over this share of the path to the peak at most.
constexpr double kWidestShare = 0.06;
/// Fewer rows make no line worth having.
constexpr std::size_t kFewestRows = 4;
/// A peak was passed where the load fell below it by so many standard deviations of the noise.
constexpr double kFallDeviations = 2.0;
/// ...or where the path goes on by this share without a larger load: a plateau.
constexpr double kPlateau = 0.1;

std::vector<double> above_base(const std::vector<double>& load, const CurveReading& reading) {
  std::vector<double> above(load);
  for (double& q : above) q -= base_load(reading);
  return above;
}

/// Eq. (F2): so many rows that their line ends with the noise that may be left, as far as they lie close together.
std::size_t smoothing_rows(const CurveShape& shape, std::size_t reach) {
  if (shape.reading.load_noise <= 0.0) return 0;
  const std::vector<double>& path = shape.first.path;
  const std::vector<double>& load = shape.first.load;
  const double wanted = std::ceil(std::pow(2.0 * shape.reading.load_noise / kNoiseLeft, 2));
  const auto top = static_cast<std::size_t>(std::max_element(load.begin(), load.begin() + reach) - load.begin());
  const double width = kWidestShare * (path[top] - path.front());
  std::size_t close = 0;
  while (close < top && path[top - close - 1] > path[top] - width) ++close;
  const std::size_t rows = std::min(static_cast<std::size_t>(std::min(wanted, 1e6)), close);
  return rows < kFewestRows ? 0 : rows;
}

/// Whether the load falls behind the peak by more than noise, or the path goes on without a larger load.
bool peak_is_passed(const CurveShape& shape, std::size_t reach) {
  const std::vector<double> load = trailing_values(shape.first.load, shape.smoothing_rows);
  const double top = load[shape.peak_row];
  const double least = top - kFallDeviations * shape.reading.load_noise * std::abs(top);
  const bool falls =
      std::any_of(load.begin() + shape.peak_row, load.begin() + reach, [&](double q) { return q < least; });
  return falls || shape.first.path[reach - 1] >= (1.0 + kPlateau) * shape.peak_path;
}

std::size_t largest_row(const std::vector<double>& load, std::size_t begin, std::size_t reach, std::size_t step) {
  std::size_t row = begin;
  for (std::size_t i = begin; i < reach; i += step) {
    if (load[i] > load[row]) row = i;
  }
  return row;
}

/// Line through every other row up to one of them: the rows between have no part in it.
double every_other(const std::vector<double>& values, std::size_t row, std::size_t rows) {
  std::vector<double> chosen;
  for (std::size_t back = std::min(rows, row) / 2 * 2; back > 0; back -= 2) chosen.push_back(values[row - back]);
  chosen.push_back(values[row]);
  return trailing_values(chosen, chosen.size() - 1).back();
}

/// Eq. (F4): where noise is smoothed, one half of the rows finds the peak and the other half tells how high it is.
void find_peak(CurveShape& shape, std::size_t reach) {
  const std::vector<double>& load = shape.first.load;
  const std::vector<double>& path = shape.first.path;
  const std::size_t rows = shape.smoothing_rows;
  const double base = base_load(shape.reading);
  if (rows == 0) {
    shape.peak_row = largest_row(load, 0, reach, 1);
    shape.peak = load[shape.peak_row] - base;
    shape.peak_path = path[shape.peak_row];
  } else {
    std::vector<double> half(load.size());
    for (std::size_t i = 0; i < load.size(); ++i) half[i] = every_other(load, i, rows);
    const std::size_t even = largest_row(half, 0, reach, 2), odd = largest_row(half, 1, reach, 2);
    shape.peak = 0.5 * (half[even > 0 ? even - 1 : 0] + half[odd - 1]) - base;
    const std::vector<double> smooth_path = trailing_values(path, rows);
    shape.peak_path = 0.5 * (smooth_path[even] + smooth_path[odd]);
    shape.peak_row = (even + odd) / 2;
  }
  shape.peak_passed = shape.peak > 0.0 && peak_is_passed(shape, reach);
}

Branch branch_of(const Curve& curve, std::size_t begin, std::size_t end, const CurveShape& shape) {
  std::vector<std::size_t> rows(end - begin);
  std::iota(rows.begin(), rows.end(), begin);
  const Curve part = select_rows(curve, rows);
  return make_branch(part.path, above_base(part.load, shape.reading), shape.smoothing_rows);
}

void split_loops(const Curve& curve, CurveShape& shape) {
  for (const CurveLoop& loop : shape.loops) {
    if (loop.back >= curve.path.size()) continue;
    shape.unloading.push_back(branch_of(curve, loop.top, loop.bottom + 1, shape));
    shape.reloading.push_back(branch_of(curve, loop.bottom, loop.back + 1, shape));
  }
}

}  // namespace

std::size_t rows_in_reach(std::span<const double> path, double limit) {
  std::size_t n = 0;
  while (n < path.size() && path[n] <= limit) ++n;
  return n;
}

CurveShape shape_of(const Curve& curve, const CurveReading& reading) {
  CurveShape shape;
  shape.reading = reading;
  shape.loops = find_loops(curve, reading);
  shape.first = select_rows(curve, first_loading_rows(curve.path.size(), shape.loops));
  const std::size_t reach = rows_in_reach(shape.first.path, reading.path_limit);
  if (shape.first.path.size() < kLeastRows || reach == 0) return shape;
  shape.smoothing_rows = smoothing_rows(shape, reach);
  find_peak(shape, reach);
  shape.branch = make_branch(shape.first.path, above_base(shape.first.load, reading), shape.smoothing_rows);
  shape.line = compliance_line(shape.branch, shape.peak_row, reading.modulus_window_low * shape.peak,
                               reading.modulus_window_high * shape.peak);
  split_loops(curve, shape);
  return shape;
}

}  // namespace asperity
