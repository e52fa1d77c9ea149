#include "core/measurement/band_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/units.hpp"
#include "core/geometry/specimen.hpp"

namespace asperity {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr int kPlaces = 16;  // per band's width

/// A band: the points whose distance along `across` from the origin is within half a width of `place`.
struct Strip {
  Vec2 across;
  double place = 0, width = 0;
  bool holds(Vec2 point) const { return std::abs(dot(point, across) - place) <= 0.5 * width; }
};

Vec2 across_direction(double angle_deg) {
  const double angle = angle_deg * units::kRadPerDeg;
  return {std::cos(angle), -std::sin(angle)};
}

/// The part of a convex polygon where dot(point, normal) is at most `limit`.
std::vector<Vec2> cut(const std::vector<Vec2>& polygon, Vec2 normal, double limit) {
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double beyond_a = dot(a, normal) - limit, beyond_b = dot(b, normal) - limit;
    if (beyond_a <= 0.0) kept.push_back(a);
    if ((beyond_a < 0.0 && beyond_b > 0.0) || (beyond_a > 0.0 && beyond_b < 0.0)) {
      kept.push_back(a + (beyond_a / (beyond_a - beyond_b)) * (b - a));
    }
  }
  return kept;
}

double area_of(const std::vector<Vec2>& polygon) {
  double doubled = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) doubled += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return 0.5 * doubled;
}

/// Of the strip inside the specimen, mm2.
double area_in(const Strip& strip, double width, double height) {
  const double x = 0.5 * width;
  const std::vector<Vec2> specimen{{-x, 0.0}, {x, 0.0}, {x, height}, {-x, height}};
  const std::vector<Vec2> below = cut(specimen, strip.across, strip.place + 0.5 * strip.width);
  return area_of(cut(below, Vec2{} - strip.across, 0.5 * strip.width - strip.place));
}

/// Scores of all places across one direction, Eq. (M22).
class Scores {
 public:
  Scores(const CrackPattern& pattern, Vec2 across, double reach, double band_width)
      : spacing_(band_width / kPlaces), first_(-reach), scores_(static_cast<std::size_t>(2.0 * reach / spacing_) + 2) {
    for (const CrackLine& crack : pattern) add(dot(crack.middle(), across), crack.length());
  }
  std::size_t size() const { return scores_.size(); }
  double operator[](std::size_t i) const { return scores_[i]; }
  double place(std::size_t i) const { return first_ + spacing_ * static_cast<double>(i); }

 private:
  void add(double at, double length) {
    const double nearest = (at - first_) / spacing_;
    const auto low = static_cast<std::size_t>(std::max(0.0, std::ceil(nearest - 0.5 * kPlaces)));
    for (std::size_t i = low; i < scores_.size() && static_cast<double>(i) <= nearest + 0.5 * kPlaces; ++i) {
      const double aside = (static_cast<double>(i) - nearest) / (0.5 * kPlaces);
      scores_[i] += length * (1.0 - aside * aside);
    }
  }
  double spacing_, first_;
  std::vector<double> scores_;
};

/// The strip of largest score, Eq. (M22); of width 0 where there is none.
struct BestStrip {
  Strip strip;
  double angle_deg = kNothing, score = 0;
};

BestStrip best_strip(const CrackPattern& pattern, const Rectangle& specimen, double band_width) {
  BestStrip best;
  for (int angle = -kFlattestBand; angle <= kFlattestBand; ++angle) {
    const Vec2 across = across_direction(angle);
    const Scores scores(pattern, across, specimen.width + specimen.height, band_width);
    for (std::size_t i = 0; i < scores.size(); ++i) {
      if (scores[i] <= best.score) continue;
      const Strip strip{across, scores.place(i), band_width};
      if (area_in(strip, specimen.width, specimen.height) < band_width * specimen.width) continue;
      best = {strip, static_cast<double>(angle), scores[i]};
    }
  }
  return best;
}

double length_in(const Strip& strip, const CrackPattern& pattern) {
  return total_length(select(pattern, [&](const CrackLine& crack) { return strip.holds(crack.middle()); }));
}

/// Standard deviation of the concentration of `count` cracks, scattered evenly, in a share of the area.
double scatter_by_chance(std::size_t count, double area_share) {
  return std::sqrt((1.0 - area_share) / (static_cast<double>(count) * area_share));
}

}  // namespace

FailureBands fit_bands(const CrackPattern& pattern, double width, double height) {
  FailureBands bands{{kNothing, kNothing}, {kNothing, kNothing}, kNothing, kNothing};
  const double length = total_length(pattern);
  const double band_width = std::max(
      kBandWidth * width, kBandCracks * length / static_cast<double>(std::max<std::size_t>(1, pattern.size())));
  CrackPattern rest = pattern;
  double shares = 0.0, area = 0.0;  // of the length and of the specimen
  for (std::size_t i = 0; i < 2; ++i) {
    const BestStrip best = best_strip(rest, {width, height}, band_width);
    if (best.score == 0.0) break;
    bands.angle_deg[i] = best.angle_deg;
    bands.share[i] = length_in(best.strip, rest) / length;
    shares += bands.share[i];
    area += area_in(best.strip, width, height) / (width * height);
    bands.concentration = shares / area;
    bands.significance = (bands.concentration - 1.0) / scatter_by_chance(pattern.size(), area);
    rest = select(rest, [&](const CrackLine& crack) { return !best.strip.holds(crack.middle()); });
  }
  return bands;
}

}  // namespace asperity
