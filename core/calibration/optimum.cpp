#include "core/calibration/optimum.hpp"

#include <algorithm>
#include <cmath>
#include <openturns/SobolSequence.hxx>

#include "core/calibration/constrained_ascent.hpp"
#include "core/calibration/solution_curve.hpp"

namespace asperity {
namespace {

constexpr double kRimRounding = 1e-9;   // coded: a solution on the sphere itself is inside
constexpr std::size_t kAscents = 8;     // best points that COBYLA starts from: it climbs, it need not search
constexpr double kWithin = 1.0 + 1e-9;  // a miss of one tolerance, with its rounding

double norm(const std::vector<double>& x) {
  double sum = 0.0;
  for (double v : x) sum += v * v;
  return std::sqrt(sum);
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

std::vector<std::vector<double>> start_points(const SearchRegion& region, std::size_t factors, std::size_t count) {
  std::vector<std::vector<double>> starts{std::vector<double>(factors, 0.0)};
  const OT::Sample sobol = OT::SobolSequence(factors).generate(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<double> x(factors);
    for (std::size_t j = 0; j < factors; ++j) x[j] = region.alpha * (2.0 * sobol(i, j) - 1.0);
    starts.push_back(drawn_in(region, std::move(x)));
  }
  return starts;
}

Optimum judged(const ResponseSystem& system, std::vector<double> x, const SearchOptions& options) {
  Optimum point{std::move(x), 0.0, true, 0};
  point.desirability = overall_desirability(system.values(point.x), system.targets(), options.desirability);
  for (double miss : system.misses(point.x))
    point.within_tolerance = point.within_tolerance && std::abs(miss) < kWithin;
  point.free_directions = free_directions(system, point.x);
  return point;
}

/// Points of a curve belong together however long it is; of two points the better is kept, or the one nearer the
/// centre.
void keep_distinct(std::vector<Optimum>& kept, const Optimum& point, double radius) {
  for (Optimum& other : kept) {
    if (distance(other.x, point.x) > radius) continue;
    if (point.desirability > other.desirability) other = point;
    return;
  }
  kept.push_back(point);
}

/// A point's standing among solutions: on a curve, its nearest point to the centre if that is still inside.
Optimum settled(const ResponseSystem& system, const SearchRegion& region, const Optimum& point,
                const SearchOptions& options) {
  if (point.free_directions == 0) return point;
  const Optimum nearest = judged(system, nearest_on_curve(system, point.x), options);
  return nearest.within_tolerance && inside(region, nearest.x) ? nearest : point;
}

void add_solution(std::vector<Optimum>& solutions, const Optimum& found, const ResponseSystem& system,
                  const SearchRegion& region, const SearchOptions& options) {
  if (!found.within_tolerance || !inside(region, found.x)) return;
  keep_distinct(solutions, settled(system, region, found, options), options.cluster_radius);
}

/// The starts of largest merit, no two of them close together.
std::vector<std::vector<double>> most_promising(const ResponseSystem& system,
                                                const std::vector<std::vector<double>>& points,
                                                const SearchOptions& options) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < points.size(); ++i) {
    order.emplace_back(-merit(system, points[i], options.desirability), i);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::vector<double>> best;
  for (const auto& [value, i] : order) {
    const bool near = std::any_of(best.begin(), best.end(), [&](const std::vector<double>& other) {
      return distance(other, points[i]) < options.cluster_radius;
    });
    if (!near) best.push_back(points[i]);
    if (best.size() == kAscents) break;
  }
  return best;
}

}  // namespace

bool inside(const SearchRegion& region, const std::vector<double>& x) {
  const double reach = region.alpha + kRimRounding;
  if (region.shape == RegionShape::sphere) return norm(x) <= reach;
  return std::all_of(x.begin(), x.end(), [&](double v) { return std::abs(v) <= reach; });
}

std::vector<double> drawn_in(const SearchRegion& region, std::vector<double> x) {
  const double length = norm(x);
  for (double& v : x) {
    if (region.shape == RegionShape::cube) v = std::clamp(v, -region.alpha, region.alpha);
    if (region.shape == RegionShape::sphere && length > region.alpha) v *= region.alpha / length;
  }
  return x;
}

Optima find_optima(const ResponseSystem& system, const SearchRegion& region, const SearchOptions& options) {
  Optima optima;
  std::vector<std::vector<double>> candidates = start_points(region, system.factors(), options.starts);
  const std::size_t starts = candidates.size();
  for (std::size_t i = 0; i < starts; ++i) {
    std::vector<double> end = least_misses(system, candidates[i]);
    add_solution(optima.solutions, judged(system, end, options), system, region, options);
    candidates.push_back(drawn_in(region, std::move(end)));
  }
  const std::vector<std::vector<double>> promising = most_promising(system, candidates, options);
  optima.compromise = judged(system, promising.front(), options);
  for (const std::vector<double>& start : promising) {
    const Optimum top = judged(system, climb(system, region, start, options.desirability), options);
    const double gained = merit(system, top.x, options.desirability);
    if (gained > merit(system, optima.compromise.x, options.desirability)) optima.compromise = top;
  }
  if (optima.solutions.empty()) add_solution(optima.solutions, optima.compromise, system, region, options);
  std::sort(optima.solutions.begin(), optima.solutions.end(),
            [](const Optimum& a, const Optimum& b) { return a.desirability > b.desirability; });
  const bool solved = !optima.solutions.empty();
  if (solved && optima.solutions.front().desirability >= optima.compromise.desirability) {
    optima.compromise = optima.solutions.front();
  }
  return optima;
}

}  // namespace asperity
