#include "core/measurement/pattern_comparison.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "core/base/units.hpp"

namespace asperity {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr double kSamePlaceMm = 1e-3;
constexpr int kParts = 4;  // of a particle's edges where its area is shared out to a grid: 16 pieces

/// Angle from the loading axis in degrees, at least -90 and below 90.
double axial_angle_deg(const CrackLine& crack) {
  const Vec2 along = crack.end[1] - crack.end[0];
  const double angle = std::atan2(along.x, along.y) / units::kRadPerDeg;
  const double turned = angle - 180.0 * std::floor((angle + 90.0) / 180.0);
  return turned < 90.0 ? turned : -90.0;
}

/// What the cumulative distributions of two patterns differ by, between neighbouring orientations.
struct Stretch {
  double difference = 0, length_deg = 0;
};

std::vector<Stretch> cumulative_difference(const CrackPattern& a, const CrackPattern& b) {
  std::vector<std::pair<double, double>> jumps;
  for (const CrackLine& crack : a) jumps.emplace_back(axial_angle_deg(crack), crack.length() / total_length(a));
  for (const CrackLine& crack : b) jumps.emplace_back(axial_angle_deg(crack), -crack.length() / total_length(b));
  std::sort(jumps.begin(), jumps.end());
  std::vector<Stretch> stretches{{0.0, jumps.front().first + 90.0}};
  double difference = 0.0;
  for (std::size_t i = 0; i < jumps.size(); ++i) {
    difference += jumps[i].second;
    stretches.push_back({difference, (i + 1 < jumps.size() ? jumps[i + 1].first : 90.0) - jumps[i].first});
  }
  return stretches;
}

/// The difference with half of the circle on either side of it.
double median_difference(std::vector<Stretch> stretches) {
  std::sort(stretches.begin(), stretches.end(),
            [](const Stretch& a, const Stretch& b) { return a.difference < b.difference; });
  double covered = 0.0;
  for (const Stretch& s : stretches) {
    covered += s.length_deg;
    if (covered >= 90.0) return s.difference;
  }
  return stretches.back().difference;
}

Vec2 at_rest(const Frame& frame, int node) {
  const auto i = static_cast<std::size_t>(node);
  return frame.position[i] - frame.displacement[i];
}

std::array<Vec2, 3> corners_at_rest(const Frame& frame, std::size_t triangle) {
  const std::array<int, 3>& nodes = frame.triangles[triangle];
  return {at_rest(frame, nodes[0]), at_rest(frame, nodes[1]), at_rest(frame, nodes[2])};
}

double area_of(const std::array<Vec2, 3>& corners) {
  return 0.5 * std::abs(cross(corners[1] - corners[0], corners[2] - corners[0]));
}

/// Area and damaged area in a square of the grid.
struct Cell {
  double area = 0, damaged = 0;
};
using Grid = std::map<std::pair<long, long>, Cell>;

/// Shares a triangle out by the middles of its kParts^2 equal pieces.
void share_out(const std::array<Vec2, 3>& corners, double damage, double cell_mm, Grid& grid) {
  const double part = area_of(corners) / (kParts * kParts);
  const auto add = [&](double u, double v) {
    const Vec2 middle =
        corners[0] + (u / kParts) * (corners[1] - corners[0]) + (v / kParts) * (corners[2] - corners[0]);
    Cell& cell = grid[{std::lround(std::floor(middle.x / cell_mm)), std::lround(std::floor(middle.y / cell_mm))}];
    cell.area += part;
    cell.damaged += part * damage;
  };
  for (int i = 0; i < kParts; ++i)
    for (int j = 0; i + j < kParts; ++j) {
      add(i + 1.0 / 3.0, j + 1.0 / 3.0);
      if (i + j + 1 < kParts) add(i + 2.0 / 3.0, j + 2.0 / 3.0);
    }
}

Grid damage_grid(const Frame& frame, double cell_mm) {
  Grid grid;
  for (std::size_t i = 0; i < frame.triangles.size(); ++i)
    share_out(corners_at_rest(frame, i), frame.damage[i], cell_mm, grid);
  return grid;
}

}  // namespace

OrientationShares orientation_shares(const CrackPattern& pattern) {
  OrientationShares shares;
  shares.fill(pattern.empty() ? kNothing : 0.0);
  const double length = total_length(pattern);
  for (const CrackLine& crack : pattern) {
    const auto bin = static_cast<std::size_t>((axial_angle_deg(crack) + 90.0) / kOrientationBinDeg);
    shares[std::min(bin, kOrientationBins - 1)] += crack.length() / length;
  }
  return shares;
}

double orientation_distance_deg(const CrackPattern& a, const CrackPattern& b) {
  if (a.empty() || b.empty()) return kNothing;
  const std::vector<Stretch> stretches = cumulative_difference(a, b);
  const double median = median_difference(stretches);
  double distance = 0.0;
  for (const Stretch& s : stretches) distance += s.length_deg * std::abs(s.difference - median);
  return distance;
}

bool same_mesh(const Frame& a, const Frame& b) {
  if (a.triangles != b.triangles || a.position.size() != b.position.size()) return false;
  for (int node = 0; node < static_cast<int>(a.position.size()); ++node)
    if (norm(at_rest(a, node) - at_rest(b, node)) > kSamePlaceMm) return false;
  return true;
}

double damage_overlap_on_mesh(const Frame& a, const Frame& b) {
  assert(same_mesh(a, b));
  double common = 0.0, either = 0.0;
  for (std::size_t i = 0; i < a.triangles.size(); ++i) {
    const double area = area_of(corners_at_rest(a, i));
    common += area * std::min(a.damage[i], b.damage[i]);
    either += area * std::max(a.damage[i], b.damage[i]);
  }
  return either > 0.0 ? common / either : kNothing;
}

double damage_overlap_on_grid(const Frame& a, const Frame& b, double cell_mm) {
  Grid first = damage_grid(a, cell_mm), second = damage_grid(b, cell_mm);
  for (const auto& [place, cell] : second) first.try_emplace(place);
  double common = 0.0, either = 0.0;
  for (const auto& [place, cell] : first) {
    const Cell other = second[place];
    common += std::min(cell.damaged, other.damaged);
    either += std::max(cell.damaged, other.damaged);
  }
  return either > 0.0 ? common / either : kNothing;
}

double mean_edge_mm(const Frame& frame) {
  double sum = 0.0;
  for (std::size_t i = 0; i < frame.triangles.size(); ++i) {
    const std::array<Vec2, 3> c = corners_at_rest(frame, i);
    sum += norm(c[1] - c[0]) + norm(c[2] - c[1]) + norm(c[0] - c[2]);
  }
  return sum / (3.0 * static_cast<double>(frame.triangles.size()));
}

}  // namespace asperity
