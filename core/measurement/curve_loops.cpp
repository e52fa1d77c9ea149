#include "core/measurement/curve_loops.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

/// A way back is one by this share of the path's range...
constexpr double kLeastShare = 0.02;
/// ...and by so many standard deviations of the path's noise: of ten thousand rows none strays so far by chance.
constexpr double kLeastDeviations = 8.0;

double least_retreat(const std::vector<double>& path, const CurveReading& reading) {
  const auto [low, high] = std::minmax_element(path.begin(), path.end());
  const double largest = std::max(std::abs(*low), std::abs(*high));
  return std::max(kLeastShare * (*high - *low), kLeastDeviations * reading.path_noise * largest);
}

/// A reload comes back to first loading within this share of the way back beyond its beginning.
constexpr double kBeyond = 0.5;

/// The row where a reload that is as far as before joins first loading: where it bears as much as before, or, of a
/// specimen that has lost strength meanwhile, where it bears most.
std::size_t joining_row(const Curve& curve, const CurveLoop& loop, const CurveReading& reading) {
  const double farthest = curve.path[loop.top] + kBeyond * (curve.path[loop.top] - curve.path[loop.bottom]);
  const double enough = curve.load[loop.top] - 2.0 * reading.load_noise * std::abs(curve.load[loop.top]);
  std::size_t most = loop.back;
  for (std::size_t i = loop.back; i < curve.path.size() && curve.path[i] <= farthest; ++i) {
    if (curve.load[i] > curve.load[most]) most = i;
    if (curve.load[most] >= enough) break;
  }
  return most;
}

}  // namespace

std::vector<CurveLoop> find_loops(const Curve& curve, const CurveReading& reading) {
  std::vector<CurveLoop> loops;
  const std::vector<double>& path = curve.path;
  if (path.empty()) return loops;
  const double least = least_retreat(path, reading);
  std::size_t top = 0, bottom = 0;
  const auto enter = [&](std::size_t back) {
    if (path[top] - path[bottom] <= least) return;
    CurveLoop loop{top, bottom, back};
    if (back < path.size()) loop.back = joining_row(curve, loop, reading);
    loops.push_back(loop);
  };
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (path[i] < path[bottom]) bottom = i;
    if (path[i] < path[top]) continue;
    enter(i);
    top = bottom = i;
  }
  enter(path.size());
  return loops;
}

std::vector<std::size_t> first_loading_rows(std::size_t rows, std::span<const CurveLoop> loops) {
  std::vector<std::size_t> kept;
  std::size_t next = 0;
  for (const CurveLoop& loop : loops) {
    for (; next <= loop.top && next < rows; ++next) kept.push_back(next);
    next = std::max(next, loop.back);
  }
  for (; next < rows; ++next) kept.push_back(next);
  return kept;
}

}  // namespace asperity
