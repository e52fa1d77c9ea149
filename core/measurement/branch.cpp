#include "core/measurement/branch.hpp"

#include <algorithm>
#include <numeric>

namespace asperity {
namespace {

/// A window that ends at a row is taken in place of the one around it only where it fits so much better: at an edge.
constexpr double kEdgeShare = 0.33;
/// A parabola over fewer rows is no smoothing.
constexpr std::size_t kFewestRows = 5;

struct Fitted {
  double value = 0;
  double square = 0;  ///< Mean square about the line.
};

/// The line over rows begin to end (inclusive), evaluated at `row`.
Fitted fit_rows(std::span<const double> values, std::size_t begin, std::size_t end, std::size_t row) {
  const auto n = static_cast<double>(end - begin + 1);
  const double middle = 0.5 * static_cast<double>(begin + end);
  double mean = 0, along = 0, spread = 0;
  for (std::size_t i = begin; i <= end; ++i) {
    const double t = static_cast<double>(i) - middle;
    mean += values[i];
    along += t * values[i];
    spread += t * t;
  }
  mean /= n;
  const double slope = spread > 0.0 ? along / spread : 0.0;
  double square = 0;
  for (std::size_t i = begin; i <= end; ++i) {
    const double miss = values[i] - mean - slope * (static_cast<double>(i) - middle);
    square += miss * miss;
  }
  return {mean + slope * (static_cast<double>(row) - middle), square / n};
}

/// The parabola over the same rows: it follows a bend that a line would cut off.
Fitted fit_parabola(std::span<const double> values, std::size_t begin, std::size_t end, std::size_t row) {
  const auto n = static_cast<double>(end - begin + 1);
  const double middle = 0.5 * static_cast<double>(begin + end);
  const double mean_square = (n * n - 1.0) / 12.0;  // of whole steps about their middle
  double mean = 0, along = 0, spread = 0, bend = 0, bend_spread = 0;
  for (std::size_t i = begin; i <= end; ++i) {
    const double t = static_cast<double>(i) - middle, p = t * t - mean_square;
    mean += values[i] / n;
    along += t * values[i];
    spread += t * t;
    bend += p * values[i];
    bend_spread += p * p;
  }
  const auto at = [&](std::size_t i) {
    const double t = static_cast<double>(i) - middle;
    return mean + along / spread * t + bend / bend_spread * (t * t - mean_square);
  };
  double square = 0;
  for (std::size_t i = begin; i <= end; ++i) square += (values[i] - at(i)) * (values[i] - at(i));
  return {at(row), square / n};
}

/// One row's value from the parabola around it or, at an edge, the line before it or after it.
double smooth_value(std::span<const double> values, std::size_t row, std::size_t half) {
  const std::size_t last = values.size() - 1;
  const auto before = [&](std::size_t n) { return row > n ? row - n : 0; };
  const auto after = [&](std::size_t n) { return std::min(last, row + n); };
  const Fitted around = fit_parabola(values, before(half), after(half), row);
  const Fitted up_to = fit_rows(values, before(half), row, row);
  const Fitted from = fit_rows(values, row, after(half), row);
  const bool can_end = row >= half, can_begin = row + half <= last;
  if (can_end && up_to.square < kEdgeShare * around.square && (!can_begin || up_to.square <= from.square)) {
    return up_to.value;
  }
  return can_begin && from.square < kEdgeShare * around.square ? from.value : around.value;
}

std::vector<double> smoothed(const std::vector<double>& values, std::size_t rows) {
  const std::size_t half = rows / 2;
  if (half < 2 || values.size() < kFewestRows) return values;
  std::vector<double> result(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) result[i] = smooth_value(values, i, half);
  return result;
}

/// The first row of which something holds; of the rows that follow it closely, the one that parts them best, Eq. (F26).
template <class Holds>
std::optional<std::size_t> first_row(const Holds& holds, std::size_t begin, std::size_t end, std::size_t closely) {
  std::size_t row = begin;
  while (row < end && !holds(row)) ++row;
  if (row >= end) return std::nullopt;
  std::vector<bool> following;
  for (std::size_t i = row; i < std::min(end, row + closely); ++i) following.push_back(holds(i));
  const std::size_t parting = row + parting_row(following);
  return parting < end && holds(parting) ? parting : row;
}

}  // namespace

Branch make_branch(std::vector<double> path, std::vector<double> load, std::size_t rows) {
  Branch branch;
  branch.smooth_path = smoothed(path, rows);
  branch.smooth_load = smoothed(load, rows);
  branch.smoothing_rows = rows;
  branch.path = std::move(path);
  branch.load = std::move(load);
  return branch;
}

std::vector<double> trailing_values(std::span<const double> values, std::size_t rows) {
  std::vector<double> result(values.begin(), values.end());
  if (rows == 0) return result;
  for (std::size_t i = rows; i < values.size(); ++i) result[i] = fit_rows(values, i - rows, i, i).value;
  return result;
}

std::size_t parting_row(const std::vector<bool>& holds) {
  int score = 0, best_score = 0;
  std::size_t best = 0;
  for (std::size_t i = 0; i < holds.size(); ++i) {
    score += holds[i] ? -1 : 1;
    if (score <= best_score) continue;
    best_score = score;
    best = i + 1;
  }
  return best;
}

std::optional<Crossing> find_crossing(const Branch& branch, double level, Direction direction, std::size_t begin,
                                      std::size_t end) {
  const std::vector<double>& load = branch.smooth_load;
  const std::vector<double>& path = branch.smooth_path;
  const auto beyond = [&](std::size_t i) {
    return direction == Direction::rising ? load[i] >= level : load[i] <= level;
  };
  const auto row = first_row(beyond, begin, std::min(end, load.size()), 2 * branch.smoothing_rows);
  if (!row) return std::nullopt;
  if (*row == begin) return Crossing{path[*row], *row, 1.0};
  const double share = beyond(*row - 1) ? 0.5 : (level - load[*row - 1]) / (load[*row] - load[*row - 1]);
  return Crossing{path[*row - 1] + share * (path[*row] - path[*row - 1]), *row, share};
}

std::optional<double> load_at(const Branch& branch, double path, std::size_t begin) {
  const std::vector<double>& there = branch.smooth_path;
  const auto beyond = [&](std::size_t i) { return there[i] >= path; };
  const auto row = first_row(beyond, begin, there.size(), 2 * branch.smoothing_rows);
  if (!row) return std::nullopt;
  if (*row == begin) return branch.smooth_load[*row];
  const double share = beyond(*row - 1) ? 0.5 : (path - there[*row - 1]) / (there[*row] - there[*row - 1]);
  return branch.smooth_load[*row - 1] + share * (branch.smooth_load[*row] - branch.smooth_load[*row - 1]);
}

std::optional<Line> compliance_line(const Branch& branch, std::size_t end, double low, double high) {
  const std::vector<std::size_t> rows = window_rows(branch.smooth_load, end, low, high);
  if (rows.size() < 3) return std::nullopt;
  const std::vector<double> load = gather(branch.load, rows), path = gather(branch.path, rows);
  const double slope = slope_in_order(load, path);
  if (slope <= 0.0) return std::nullopt;
  const auto n = static_cast<double>(rows.size());
  const double mean_load = std::accumulate(load.begin(), load.end(), 0.0) / n;
  const double mean_path = std::accumulate(path.begin(), path.end(), 0.0) / n;
  return Line{slope, mean_path - slope * mean_load};
}

}  // namespace asperity
