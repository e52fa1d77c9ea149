#include "core/geometry/joint_profile.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/units.hpp"

namespace asperity {
namespace {

std::vector<Vec2> points_of_teeth(const JointConfig& joint) {
  std::vector<Vec2> points{{0.0, 0.0}};
  const auto go_to = [&](double dx, double y) {
    if (dx > 0.0) points.push_back({points.back().x + dx, y});
  };
  for (const ToothConfig& tooth : joint.profile) {
    const double half = tooth.height_mm / std::tan(tooth.angle_deg * units::kRadPerDeg);
    go_to(tooth.gap_before_mm, 0.0);
    go_to(half, tooth.height_mm);
    go_to(half, 0.0);
  }
  go_to(joint.end_gap_mm, 0.0);
  return points;
}

std::vector<Vec2> moved_to_zero(std::vector<Vec2> points) {
  const double begin = points.front().x;
  for (Vec2& p : points) p.x -= begin;
  return points;
}

bool collinear(Vec2 a, Vec2 b, Vec2 c) {
  constexpr double kSine = 1e-9;  // Of the angle between the pieces: decimal input is good to 1e-16.
  const Vec2 u = b - a, v = c - b;
  return std::abs(cross(u, v)) <= kSine * norm(u) * norm(v);
}

std::vector<Vec2> without_collinear(const std::vector<Vec2>& points) {
  std::vector<Vec2> corners;
  for (const Vec2& p : points) {
    while (corners.size() > 1 && collinear(corners[corners.size() - 2], corners.back(), p)) corners.pop_back();
    corners.push_back(p);
  }
  return corners;
}

/// The profile with everything below the plane raised onto it, and corners where it crosses the plane.
std::vector<Vec2> above_plane(const std::vector<Vec2>& points) {
  std::vector<Vec2> clipped;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 p = points[i];
    if (i > 0 && p.y * points[i - 1].y < 0.0) {
      const Vec2 a = points[i - 1];
      clipped.push_back({a.x + (p.x - a.x) * a.y / (a.y - p.y), 0.0});
    }
    clipped.push_back({p.x, std::max(p.y, 0.0)});
  }
  return clipped;
}

double angle_deg(double rise, double run) { return run > 0.0 ? std::atan2(rise, run) / units::kRadPerDeg : 0.0; }

ToothSpan tooth_between(Vec2 begin, Vec2 crest, Vec2 end) {
  return {begin.x,
          crest.x,
          end.x,
          crest.y,
          angle_deg(crest.y - begin.y, crest.x - begin.x),
          angle_deg(crest.y - end.y, end.x - crest.x)};
}

/// Walks over the part above the plane: flats are left out, then a tooth climbs (ledges and a flat crest included),
/// then it falls (ledges included) to its last foot.
std::vector<ToothSpan> find_teeth(const std::vector<Vec2>& points) {
  const std::vector<Vec2> line = above_plane(points);
  const std::size_t last = line.size() - 1;
  std::vector<ToothSpan> teeth;
  for (std::size_t i = 0; i < last;) {
    while (i < last && line[i + 1].y == line[i].y) ++i;
    if (i == last) break;
    const std::size_t begin = i;
    std::size_t crest = i;
    for (; i < last && line[i + 1].y >= line[i].y; ++i)
      if (line[i + 1].y > line[i].y) crest = i + 1;
    const Vec2 top{0.5 * (line[crest].x + line[i].x), line[i].y};
    std::size_t end = i;
    for (; i < last && line[i + 1].y <= line[i].y; ++i)
      if (line[i + 1].y < line[i].y) end = i + 1;
    if (top.y > 0.0) teeth.push_back(tooth_between(line[begin], top, line[end]));
  }
  return teeth;
}

bool lower(Vec2 a, Vec2 b) { return a.y < b.y; }

}  // namespace

double JointProfile::height_at(double x) const {
  const auto right = std::find_if(points.begin() + 1, points.end() - 1, [x](Vec2 p) { return p.x >= x; });
  const Vec2 a = *(right - 1), b = *right;
  return a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x);
}

double JointProfile::lowest() const { return std::min_element(points.begin(), points.end(), lower)->y; }
double JointProfile::highest() const { return std::max_element(points.begin(), points.end(), lower)->y; }

JointProfile joint_profile(const JointConfig& joint) {
  std::vector<Fault> faults = profile_faults(joint);
  if (!faults.empty()) throw Error(ErrorKind::config, std::move(faults));
  JointProfile profile;
  profile.points = without_collinear(joint.points_mm.empty() ? points_of_teeth(joint) : moved_to_zero(joint.points_mm));
  profile.teeth = find_teeth(profile.points);
  return profile;
}

}  // namespace asperity
