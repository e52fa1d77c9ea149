#include "core/geometry/joint_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/units.hpp"

namespace asperity {
namespace {

constexpr double kMostScatter = 0.2;  // Of points along a line.

/// Adds corners, and lines of points between them.
class LineBuilder {
 public:
  LineBuilder(JointLines& lines, const LineSpacing& spacing, RandomStream& random)
      : lines_(lines), edge_(spacing.edge_mm), scatter_(std::min(spacing.scatter, kMostScatter)), random_(random) {}

  int corner(Vec2 at) {
    lines_.set.points.push_back({at, Freedom::fixed});
    return static_cast<int>(lines_.set.points.size()) - 1;
  }

  /// Points that may slide along a straight line between two corners; returns all from `begin` to `end`.
  std::vector<int> straight(int begin, int end) {
    const Side side = straight_side(at(begin), at(end));
    return sliding(begin, end, side, cuts(side.length()));
  }

  /// Moves a sliding point along its line to a number of edges from the line's corner, and fixes it there.
  void pin(int point, int corner, double edges) {
    MeshPoint& moved = lines_.set.points[point];
    const Vec2 d = moved.at - at(corner);
    moved.at = at(corner) + (edges * edge_ / norm(d)) * d;
    moved.freedom = Freedom::fixed;
  }

  /// Fixed points along a line of many short pieces, from one of its ends, a corner, to the other.
  std::vector<int> winding(int begin, const std::vector<Vec2>& pieces, int end) {
    std::vector<double> along{0.0};
    for (std::size_t i = 1; i < pieces.size(); ++i) along.push_back(along.back() + norm(pieces[i] - pieces[i - 1]));
    const std::vector<double> cut = cuts(along.back());
    std::vector<int> line{begin};
    for (std::size_t i = 1, k = 1; i + 1 < cut.size(); ++i) {
      while (along[k] < cut[i]) ++k;
      const double share = (cut[i] - along[k - 1]) / (along[k] - along[k - 1]);
      line.push_back(corner(pieces[k - 1] + share * (pieces[k] - pieces[k - 1])));
    }
    line.push_back(end);
    return joined(line);
  }

  Vec2 at(int point) const { return lines_.set.points[point].at; }
  bool slides(int point) const { return lines_.set.points[point].freedom == Freedom::sliding; }

 private:
  std::vector<int> sliding(int begin, int end, const Side& side, const std::vector<double>& cut) {
    const int number = static_cast<int>(lines_.sides.sides.size());
    lines_.sides.sides.push_back(side);
    std::vector<int> line{begin};
    for (std::size_t i = 1; i + 1 < cut.size(); ++i) {
      line.push_back(static_cast<int>(lines_.set.points.size()));
      lines_.set.points.push_back({side.at(cut[i]), Freedom::sliding, number, cut[i]});
    }
    line.push_back(end);
    return joined(line);
  }

  std::vector<double> cuts(double length) {
    const int pieces = std::max(1, static_cast<int>(std::lround(length / edge_)));
    return random_cuts(length, pieces, scatter_, random_);
  }

  std::vector<int> joined(const std::vector<int>& line) {
    for (std::size_t i = 1; i < line.size(); ++i) lines_.set.segments.push_back({line[i - 1], line[i]});
    return line;
  }

  JointLines& lines_;
  double edge_, scatter_;
  RandomStream& random_;
};

/// Appends a line that begins where the other ends (or may begin anywhere, if there is none yet).
void append(std::vector<int>& line, const std::vector<int>& more) {
  line.insert(line.end(), more.begin() + (line.empty() ? 0 : 1), more.end());
}

void append_reversed(std::vector<int>& line, std::vector<int> more) {
  std::reverse(more.begin(), more.end());
  append(line, more);
}

/// The joint's line, and where its corners stand in it.
struct JointLine {
  std::vector<int> points;
  std::vector<std::size_t> corner;
  std::vector<int> part(std::size_t first, std::size_t last) const {
    return {points.begin() + corner[first], points.begin() + corner[last] + 1};
  }
};

/// In a sharp corner the points of both lines must not face each other, or flat triangles follow. These distances leave
/// no angle below 25 degrees but the corner's own, down to 12 degrees.
void stagger(LineBuilder& builder, int corner, const std::array<int, 2>& on_one, int on_other) {
  constexpr double kSharpDeg = 40.0;
  const Vec2 u = builder.at(on_one[0]) - builder.at(corner), v = builder.at(on_other) - builder.at(corner);
  if (std::atan2(std::abs(cross(u, v)), dot(u, v)) > kSharpDeg * units::kRadPerDeg) return;
  if (!builder.slides(on_one[0]) || !builder.slides(on_one[1]) || !builder.slides(on_other)) return;
  builder.pin(on_one[0], corner, 1.0);
  builder.pin(on_other, corner, 1.35);
  builder.pin(on_one[1], corner, 1.9);
}

JointLine add_joint(LineBuilder& builder, const JointProfile& profile) {
  JointLine joint;
  joint.points.push_back(builder.corner(profile.points.front()));
  joint.corner.push_back(0);
  for (std::size_t i = 1; i < profile.points.size(); ++i) {
    append(joint.points, builder.straight(joint.points.back(), builder.corner(profile.points[i])));
    joint.corner.push_back(joint.points.size() - 1);
  }
  for (std::size_t i = 1; i + 1 < joint.corner.size(); ++i) {
    const std::size_t at = joint.corner[i];
    if (at > 1) stagger(builder, joint.points[at], {joint.points[at - 1], joint.points[at - 2]}, joint.points[at + 1]);
  }
  return joint;
}

/// A zone below the joint between two of its corners, down to a floor; with a wall where the corner is not on the
/// floor.
void add_zone_below(LineBuilder& builder, JointLines& lines, const std::vector<int>& above, double floor_y) {
  const auto foot = [&](int corner) {
    const Vec2 p = builder.at(corner);
    return p.y == floor_y ? corner : builder.corner({p.x, floor_y});
  };
  const int left = foot(above.front()), right = foot(above.back());
  const std::vector<int> floor = builder.straight(left, right);
  if (left == above.front()) stagger(builder, left, {above[1], above[2]}, floor[1]);
  if (right == above.back())
    stagger(builder, right, {above[above.size() - 2], above[above.size() - 3]}, floor[floor.size() - 2]);
  std::vector<int> zone = above;
  if (right != above.back()) append(zone, builder.straight(above.back(), right));
  append_reversed(zone, floor);
  if (left != above.front()) append(zone, builder.straight(left, above.front()));
  zone.pop_back();
  lines.zones.push_back(std::move(zone));
  append(lines.lower_border, floor);
}

/// Zones end at corners on the floor; between two of them, the joint may run along the floor itself.
void add_lower_zones(LineBuilder& builder, JointLines& lines, const JointLine& joint, double floor_y) {
  const std::size_t corners = joint.corner.size();
  const auto on_floor = [&](std::size_t corner) { return builder.at(joint.points[joint.corner[corner]]).y == floor_y; };
  for (std::size_t first = 0, last = 1; last < corners; ++last) {
    if (!on_floor(last) && last + 1 < corners) continue;
    const bool flat = last == first + 1 && on_floor(first) && on_floor(last);
    if (flat)
      append(lines.lower_border, joint.part(first, last));
    else
      add_zone_below(builder, lines, joint.part(first, last), floor_y);
    first = last;
  }
}

std::vector<Vec2> roof(const JointProfile& profile, double depth, double highest, double step) {
  const int steps = std::max(1, static_cast<int>(std::ceil(profile.length() / step)));
  std::vector<Vec2> line;
  for (int i = 0; i <= steps; ++i) {
    const double x = i < steps ? profile.length() * i / steps : profile.length();
    line.push_back({x, std::min(roof_height(profile, depth, x), highest)});
  }
  return line;
}

void add_upper_zone(LineBuilder& builder, JointLines& lines, const std::vector<Vec2>& roof) {
  const int left = builder.corner(roof.front()), right = builder.corner(roof.back());
  lines.upper_border = builder.winding(left, roof, right);
  std::vector<int> zone = lines.joint;
  append(zone, builder.straight(lines.joint.back(), right));
  append_reversed(zone, lines.upper_border);
  append(zone, builder.straight(left, lines.joint.front()));
  zone.pop_back();
  lines.zones.push_back(std::move(zone));
}

}  // namespace

double roof_height(const JointProfile& profile, double depth_mm, double x) {
  double height = profile.height_at(x);
  for (const Vec2& p : profile.points) {
    const double reach = depth_mm * depth_mm - (x - p.x) * (x - p.x);
    if (reach >= 0.0) height = std::max(height, p.y + std::sqrt(reach));
  }
  for (std::size_t i = 1; i < profile.points.size(); ++i) {
    const Vec2 a = profile.points[i - 1], d = profile.points[i] - a;
    const Vec2 shifted = a + (depth_mm / norm(d)) * Vec2{-d.y, d.x};
    const double share = (x - shifted.x) / d.x;
    if (share >= 0.0 && share <= 1.0) height = std::max(height, shifted.y + share * d.y);
  }
  return height;
}

JointLines joint_lines(const JointConfig& joint, const JointProfile& profile, const LineSpacing& spacing,
                       RandomStream& random) {
  constexpr double kRoofStep = 0.1;  // Over the particles' edge.
  JointLines lines;
  LineBuilder builder(lines, spacing, random);
  const JointLine line = add_joint(builder, profile);
  lines.joint = line.points;
  lines.upper_border = line.points;
  const double deepest = std::min(profile.lowest(), joint.coarse_edge_mm - joint.lower_height_mm);
  const double floor = std::max(profile.lowest() - joint.damage_depth_lower_mm, deepest);
  add_lower_zones(builder, lines, line, floor);
  if (joint.damage_depth_upper_mm > 0.0)
    add_upper_zone(builder, lines,
                   roof(profile, joint.damage_depth_upper_mm, joint.upper_height_mm - joint.coarse_edge_mm,
                        kRoofStep * spacing.edge_mm));
  return lines;
}

}  // namespace asperity
