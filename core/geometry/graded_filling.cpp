#include "core/geometry/graded_filling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/geometry/outline.hpp"

namespace asperity {
namespace {

constexpr double kGrowth = 0.3;    // Of the edge, with the distance to the fine line.
constexpr double kSpacing = 0.75;  // Over the edge: closest that two points are placed.
constexpr double kRing = 1.6;      // Candidates lie at 1 to 1.6 spacings from an old point.
constexpr int kCandidates = 30;    // For each old point (Bridson 2007).
constexpr int kSmoothings = 40;
constexpr double kSharpDeg = 25.0;

/// Arc lengths from 0 to the side's length at equal steps of the number of edges passed.
std::vector<double> graded_cuts(const Side& side, const Grading& grading) {
  const double length = side.length();
  const int samples = std::max(8, static_cast<int>(std::ceil(8.0 * length / grading.fine_edge_mm)));
  std::vector<double> passed{0.0};  // Edges up to each sample.
  for (int i = 0; i < samples; ++i)
    passed.push_back(passed.back() + length / samples / grading.edge_at(side.at(length * (i + 0.5) / samples)));
  const int pieces = std::max(1, static_cast<int>(std::lround(passed.back())));
  std::vector<double> cuts{0.0};
  for (int i = 1, k = 1; i < pieces; ++i) {
    const double wanted = passed.back() * i / pieces;
    while (passed[k] < wanted) ++k;
    const double share = (wanted - passed[k - 1]) / (passed[k] - passed[k - 1]);
    cuts.push_back(length * (k - 1 + share) / samples);
  }
  cuts.push_back(length);
  return cuts;
}

PointSet graded_border(const Grading& grading, const std::vector<Vec2>& outer) {
  PointSet set;
  const auto add = [&](Vec2 at) { set.points.push_back({at, Freedom::fixed}); };
  for (const Vec2& p : grading.fine) add(p);
  for (std::size_t i = 0; i <= outer.size(); ++i) {
    const Vec2 begin = i > 0 ? outer[i - 1] : grading.fine.back();
    const Side side = straight_side(begin, i < outer.size() ? outer[i] : grading.fine.front());
    const std::vector<double> cuts = graded_cuts(side, grading);
    if (i > 0) add(begin);
    for (std::size_t k = 1; k + 1 < cuts.size(); ++k) add(side.at(cuts[k]));
  }
  const int n = static_cast<int>(set.points.size());
  for (int i = 0; i < n; ++i) set.segments.push_back({i, (i + 1) % n});
  return set;
}

/// Points with the edge length that is wanted around each.
struct Placed {
  Vec2 at;
  double edge_mm;
};

bool crowded(const std::vector<Placed>& placed, const Placed& candidate) {
  return std::any_of(placed.begin(), placed.end(), [&](const Placed& p) {
    const Vec2 d = p.at - candidate.at;
    const double spacing = 0.5 * kSpacing * (p.edge_mm + candidate.edge_mm);
    return dot(d, d) < spacing * spacing;
  });
}

/// Random points inside, none nearer than kSpacing edges to another or to the border, until no more fit: candidates are
/// thrown around the points there are, beginning with the border (Bridson, SIGGRAPH sketches 2007).
void place_inside(PointSet& set, const Grading& grading, RandomStream& random) {
  const std::vector<Vec2> border = positions(set);
  std::vector<Placed> placed;
  for (const Vec2& p : border) placed.push_back({p, grading.edge_at(p)});
  for (std::size_t i = 0; i < placed.size(); ++i) {
    for (int k = 0; k < kCandidates; ++k) {
      const double distance = kSpacing * placed[i].edge_mm * random.uniform(1.0, kRing);
      const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
      const Vec2 at = placed[i].at + distance * Vec2{std::cos(angle), std::sin(angle)};
      const Placed candidate{at, grading.edge_at(at)};
      if (!contains(border, at) || crowded(placed, candidate)) continue;
      placed.push_back(candidate);
      set.points.push_back({at});
    }
  }
}

}  // namespace

double Grading::edge_at(Vec2 p) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vec2& q : fine) nearest = std::min(nearest, dot(p - q, p - q));
  return std::min(coarse_edge_mm, fine_edge_mm + kGrowth * std::sqrt(nearest));
}

GradedFilling fill_graded(const Grading& grading, const std::vector<Vec2>& outer, RandomStream& random) {
  GradedFilling filling{graded_border(grading, outer), {}};
  mark_sharp_corners(filling.set, kSharpDeg);
  place_inside(filling.set, grading, random);
  filling.filled = smooth(filling.set, kSmoothings);
  return filling;
}

}  // namespace asperity
