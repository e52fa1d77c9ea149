#include "core/geometry/points.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/units.hpp"
#include "core/geometry/box.hpp"

namespace asperity {
namespace {

/// Cut off, so that no single draw can make a sliver.
double scattered(double scatter, RandomStream& random) {
  return 1.0 + scatter * std::clamp(random.normal(), -2.0, 2.0);
}

/// Finds points nearer than the spacing. A cell is as wide as the spacing, so the 3 x 3 cells around a point suffice.
class HashGrid {
 public:
  HashGrid(const Box& box, double spacing)
      : low_(box.low),
        spacing_(spacing),
        columns_(cells(box.high.x - box.low.x)),
        rows_(cells(box.high.y - box.low.y)),
        cells_(static_cast<std::size_t>(columns_) * rows_) {}

  void add(Vec2 p) { cells_[index(column(p), row(p))].push_back(p); }

  bool crowded(Vec2 p) const {
    for (int r = std::max(row(p) - 1, 0); r <= std::min(row(p) + 1, rows_ - 1); ++r)
      for (int c = std::max(column(p) - 1, 0); c <= std::min(column(p) + 1, columns_ - 1); ++c)
        for (const Vec2& q : cells_[index(c, r)])
          if (norm(p - q) < spacing_) return true;
    return false;
  }

 private:
  int cells(double extent) const { return static_cast<int>(extent / spacing_) + 1; }
  int column(Vec2 p) const { return std::clamp(static_cast<int>((p.x - low_.x) / spacing_), 0, columns_ - 1); }
  int row(Vec2 p) const { return std::clamp(static_cast<int>((p.y - low_.y) / spacing_), 0, rows_ - 1); }
  std::size_t index(int c, int r) const { return static_cast<std::size_t>(r) * columns_ + c; }

  Vec2 low_;
  double spacing_;
  int columns_, rows_;
  std::vector<std::vector<Vec2>> cells_;
};

}  // namespace

std::vector<double> random_cuts(double length, int pieces, double scatter, RandomStream& random) {
  std::vector<double> cuts{0.0};
  for (int i = 0; i < pieces; ++i) cuts.push_back(cuts.back() + scattered(scatter, random));
  const double scale = length / cuts.back();
  for (double& cut : cuts) cut *= scale;
  return cuts;
}

void mark_sharp_corners(PointSet& set, double angle_deg) {
  std::vector<std::vector<double>> directions(set.points.size());
  const auto add = [&](int from, int to) {
    const Vec2 d = set.points[to].at - set.points[from].at;
    directions[from].push_back(std::atan2(d.y, d.x));
  };
  for (const auto& [a, b] : set.segments) add(a, b), add(b, a);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    std::vector<double>& at = directions[i];
    if (at.size() < 2) continue;
    std::sort(at.begin(), at.end());
    double least = at.front() + 2.0 * std::numbers::pi - at.back();
    for (std::size_t k = 1; k < at.size(); ++k) least = std::min(least, at[k] - at[k - 1]);
    set.points[i].sharp = least < angle_deg * units::kRadPerDeg;
  }
}

PointSet place_on_outline(const Outline& outline, double edge_mm, double scatter, RandomStream& random) {
  PointSet set;
  for (int s = 0; s < static_cast<int>(outline.sides.size()); ++s) {
    const Side& side = outline.sides[s];
    const int pieces = std::max(1, static_cast<int>(std::lround(side.length() / edge_mm)));
    const std::vector<double> cuts = random_cuts(side.length(), pieces, scatter, random);
    set.points.push_back({side.start, Freedom::fixed});
    for (int i = 1; i < pieces; ++i) set.points.push_back({side.at(cuts[i]), Freedom::sliding, s, cuts[i]});
  }
  const int n = static_cast<int>(set.points.size());
  for (int i = 0; i < n; ++i) set.segments.push_back({i, (i + 1) % n});
  return set;
}

void throw_darts(PointSet& set, const std::vector<Vec2>& polygon, int count, double spacing_mm, RandomStream& random) {
  constexpr int kThrowsPerPoint = 60;  // Finds 95 % of the places at the densities used here.
  const Box box = bounding_box(polygon);
  HashGrid grid(box, spacing_mm);
  for (const MeshPoint& point : set.points) grid.add(point.at);
  int placed = 0;
  for (long throws = 0; placed < count && throws < static_cast<long>(kThrowsPerPoint) * count; ++throws) {
    const double x = random.uniform(box.low.x, box.high.x);
    const Vec2 p{x, random.uniform(box.low.y, box.high.y)};
    if (grid.crowded(p) || !contains(polygon, p)) continue;
    grid.add(p);
    set.points.push_back({p});
    ++placed;
  }
}

std::vector<Vec2> positions(const PointSet& set) {
  std::vector<Vec2> at;
  at.reserve(set.points.size());
  for (const MeshPoint& point : set.points) at.push_back(point.at);
  return at;
}

bool contains(const std::vector<Vec2>& polygon, Vec2 p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2 a = polygon[i], b = polygon[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
  }
  return inside;
}

}  // namespace asperity
