#include "core/measurement/branch.hpp"

#include <algorithm>

namespace asperity {
namespace {

/// A window that ends at a row is taken in place of the one around it only where it fits so much better: at an edge.
constexpr double kEdgeShare = 0.5;

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

/// One row's value from the best of the windows around it, before it and after it.
double smooth_value(std::span<const double> values, std::size_t row, std::size_t half) {
  const std::size_t last = values.size() - 1;
  const auto before = [&](std::size_t n) { return row > n ? row - n : 0; };
  const auto after = [&](std::size_t n) { return std::min(last, row + n); };
  const Fitted around = fit_rows(values, before(half), after(half), row);
  const Fitted up_to = fit_rows(values, before(2 * half), row, row);
  const Fitted from = fit_rows(values, row, after(2 * half), row);
  const bool can_end = row >= 2 * half, can_begin = row + 2 * half <= last;
  if (can_end && up_to.square < kEdgeShare * around.square && (!can_begin || up_to.square <= from.square)) {
    return up_to.value;
  }
  return can_begin && from.square < kEdgeShare * around.square ? from.value : around.value;
}

std::vector<double> smoothed(const std::vector<double>& values, std::size_t rows) {
  const std::size_t half = rows / 2;
  if (half == 0) return values;
  std::vector<double> result(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) result[i] = smooth_value(values, i, half);
  return result;
}

}  // namespace

Branch make_branch(std::vector<double> path, std::vector<double> load, std::size_t rows) {
  Branch branch;
  branch.smooth_path = smoothed(path, rows);
  branch.smooth_load = smoothed(load, rows);
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

std::optional<Crossing> find_crossing(const Branch& branch, double level, Direction direction, std::size_t begin,
                                      std::size_t end) {
  const std::vector<double>& load = branch.smooth_load;
  const std::vector<double>& path = branch.smooth_path;
  const auto beyond = [&](std::size_t i) { return direction == Direction::rising ? load[i] >= level : load[i] <= level; };
  for (std::size_t i = begin; i < std::min(end, load.size()); ++i) {
    if (!beyond(i)) continue;
    if (i == begin || load[i] == load[i - 1]) return Crossing{path[i], i};
    const double share = (level - load[i - 1]) / (load[i] - load[i - 1]);
    return Crossing{path[i - 1] + share * (path[i] - path[i - 1]), i};
  }
  return std::nullopt;
}

std::optional<double> load_at(const Branch& branch, double path, std::size_t begin) {
  for (std::size_t i = begin; i < branch.smooth_path.size(); ++i) {
    const double there = branch.smooth_path[i];
    if (there < path) continue;
    if (i == begin || there == branch.smooth_path[i - 1]) return branch.smooth_load[i];
    const double before = branch.smooth_path[i - 1];
    const double share = (path - before) / (there - before);
    return branch.smooth_load[i - 1] + share * (branch.smooth_load[i] - branch.smooth_load[i - 1]);
  }
  return std::nullopt;
}

std::optional<Line> compliance_line(const Branch& branch, std::size_t end, double low, double high) {
  const std::vector<std::size_t> rows = window_rows(branch.load, end, low, high);
  if (rows.size() < 3) return std::nullopt;
  const std::vector<double> load = gather(branch.load, rows);
  if (*std::max_element(load.begin(), load.end()) <= *std::min_element(load.begin(), load.end())) return std::nullopt;
  const Line line = fit_line(load, gather(branch.path, rows));
  if (line.slope <= 0.0) return std::nullopt;
  return line;
}

}  // namespace asperity
