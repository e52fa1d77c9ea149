#include "core/measurement/failure_mode.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace asperity {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

bool is_tension(const CrackLine& crack) { return crack.mode == BreakMode::tension; }

/// From the lowest to the highest value of a coordinate of the cracks' ends.
double extent(const CrackPattern& pattern, double Vec2::*coordinate) {
  if (pattern.empty()) return 0.0;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const CrackLine& crack : pattern) {
    for (const Vec2& end : crack.end) {
      low = std::min(low, end.*coordinate);
      high = std::max(high, end.*coordinate);
    }
  }
  return high - low;
}

}  // namespace

CrackTotals crack_totals(const CrackPattern& pattern) {
  const auto tension = static_cast<int>(std::count_if(pattern.begin(), pattern.end(), is_tension));
  return {tension, static_cast<int>(pattern.size()) - tension, total_length(pattern),
          length_share(pattern, is_tension)};
}

double DiscFailure::path_tension_share() const { return length_share(path, is_tension); }

double DiscFailure::path_offset_mm() const {
  double offset = splits() ? 0.0 : kNothing;
  for (const CrackLine& crack : path) {
    for (const Vec2& end : crack.end) offset = std::max(offset, std::abs(end.x));
  }
  return offset;
}

const char* DiscFailure::verdict() const {
  if (cracks.length_mm == 0.0) return "none";
  if (!splits()) return "no split";
  return path_tension_share() >= 0.5 ? "tension split" : "shear split";
}

DiscFailure disc_failure(const CrackPattern& pattern, double diameter) {
  const auto at_bottom = [&](Vec2 place) { return place.y < kDiscEnd * diameter; };
  const auto at_top = [&](Vec2 place) { return place.y > (1.0 - kDiscEnd) * diameter; };
  const auto central = [&](const CrackLine& crack) { return std::abs(crack.middle().x) < kCentralBand * diameter; };
  const auto at_end = [&](const CrackLine& crack) { return at_bottom(crack.middle()) || at_top(crack.middle()); };
  return {crack_totals(pattern), axial_statistics(pattern), length_share(select(pattern, is_tension), central),
          length_share(pattern, at_end), shortest_path(pattern, at_bottom, at_top)};
}

const char* CompressionFailure::verdict() const {
  if (cracks.length_mm < width_mm) return "none";
  const bool concentrated = bands.concentration >= kConcentrated && bands.significance >= kSignificant;
  const bool steep = concentrated && std::abs(bands.angle_deg[0]) < kAxial;
  const bool split = spans_height() && !spans_width();
  if (cracks.tension_share >= 0.5 && (split || steep)) return "axial splitting";
  return concentrated ? "oblique band" : "diffuse";
}

CompressionFailure compression_failure(const CrackPattern& pattern, double width, double height) {
  const CrackPattern cluster = largest_cluster(pattern);
  CompressionFailure failure;
  failure.cracks = crack_totals(pattern);
  failure.orientation = axial_statistics(pattern);
  failure.cluster_share = pattern.empty() ? kNothing : total_length(cluster) / failure.cracks.length_mm;
  failure.cluster = principal_direction(cluster);
  failure.cluster_width_share = extent(cluster, &Vec2::x) / width;
  failure.cluster_height_share = extent(cluster, &Vec2::y) / height;
  failure.bands = fit_bands(pattern, width, height);
  failure.width_mm = width;
  return failure;
}

FragmentShares fragment_shares(const Fragments& fragments) {
  const std::vector<double>& area = fragments.area_mm2;
  const double sum = std::accumulate(area.begin(), area.end(), 0.0);
  return {area.front() / sum, area.size() > 1 ? area[1] / sum : 0.0};
}

}  // namespace asperity
