#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/units.hpp"
#include "core/config/schema_lookup.hpp"
#include "core/geometry/joint_profile.hpp"

namespace asperity {
namespace {

constexpr double kSteepestDeg = 80.0;
constexpr double kShortestPiece = 1.5;  // Over the particles' edge: a straight piece must hold an edge or two of them.
constexpr double kRounding = 1e-9;
constexpr double kSharpestFootDeg = 12.0;  // Of a zone that ends at the teeth's feet; sharper ones cannot be filled.

std::string rounded(double number) { return fmt::format("{:.4g}", number); }

void check_tooth(const ToothConfig& tooth, const std::string& at, std::vector<Fault>& faults) {
  if (!(tooth.angle_deg > 0.0 && tooth.angle_deg < kSteepestDeg))
    faults.push_back({at + "/angle_deg", "is no angle of a tooth's flanks", number_text(tooth.angle_deg),
                      "above 0, below 80 degrees", "it is measured against the joint's plane"});
  if (!(tooth.height_mm > 0.0))
    faults.push_back({at + "/height_mm", "a tooth rises above the joint's plane", number_text(tooth.height_mm),
                      "above 0 mm", "leave the tooth out for a flat joint"});
  if (!(tooth.gap_before_mm >= 0.0))
    faults.push_back({at + "/gap_before_mm", "teeth would overlap", number_text(tooth.gap_before_mm), "0 mm or more",
                      "with 0 a tooth begins where the one before it ends"});
}

void check_teeth(const JointConfig& joint, std::vector<Fault>& faults) {
  for (std::size_t i = 0; i < joint.profile.size(); ++i)
    check_tooth(joint.profile[i], fmt::format("/joint/profile/{}", i), faults);
  if (!(joint.end_gap_mm >= 0.0))
    faults.push_back({"/joint/end_gap_mm", "the joint would end inside its last tooth", number_text(joint.end_gap_mm),
                      "0 mm or more", "with 0 the joint ends with its last tooth"});
  if (joint.profile.empty() && joint.end_gap_mm == 0.0)
    faults.push_back({"/joint/profile", "the joint has no length", "", "a tooth, or a flat part",
                      "add a tooth, or set /joint/end_gap_mm to the length of a flat joint"});
}

std::string point_text(Vec2 p) { return fmt::format("[{}, {}]", number_text(p.x), number_text(p.y)); }

void check_point_after(Vec2 before, Vec2 p, const std::string& at, std::vector<Fault>& faults) {
  if (!(p.x > before.x)) {
    faults.push_back({at, "the profile runs back over itself, so the halves would overlap", point_text(p),
                      "x above " + number_text(before.x) + " mm, that of the point before",
                      "order the points by x; a profile has no overhang"});
    return;
  }
  const double slope = std::atan2(std::abs(p.y - before.y), p.x - before.x) / units::kRadPerDeg;
  if (!(slope < kSteepestDeg))
    faults.push_back({at, "the profile is too steep before this point", rounded(slope) + " degrees",
                      "below 80 degrees against the joint's plane", "move the point, or leave it out"});
}

void check_points(const std::vector<Vec2>& points, std::vector<Fault>& faults) {
  if (points.size() < 2)
    faults.push_back({"/joint/points_mm", "one point is no profile", fmt::format("{} point", points.size()),
                      "two points or more", "add points, or remove the key and give teeth in /joint/profile"});
  for (std::size_t i = 1; i < points.size(); ++i)
    check_point_after(points[i - 1], points[i], fmt::format("/joint/points_mm/{}", i), faults);
}

/// A half must hold the profile, a layer of particles where it has any, and one coarse edge beyond.
struct Half {
  std::string_view height_key, depth_key;
  double height_mm, depth_mm;
  double reach_mm;  ///< Of the profile into this half, from the plane.
};

std::array<Half, 2> halves(const JointConfig& joint, const JointProfile& profile) {
  return {{{"/joint/lower_height_mm", "/joint/damage_depth_lower_mm", joint.lower_height_mm,
            joint.damage_depth_lower_mm, std::max(0.0, -profile.lowest())},
           {"/joint/upper_height_mm", "/joint/damage_depth_upper_mm", joint.upper_height_mm,
            joint.damage_depth_upper_mm, std::max(0.0, profile.highest())}}};
}

void check_height(const Half& half, double coarse_mm, std::vector<Fault>& faults) {
  const double least = half.reach_mm + coarse_mm;
  if (half.height_mm >= least) return;
  faults.push_back({std::string(half.height_key), "the profile reaches to the half's outer edge: overlapping halves",
                    number_text(half.height_mm),
                    fmt::format("at least {} mm: the profile's {} mm and coarse_edge_mm {}", rounded(least),
                                rounded(half.reach_mm), number_text(coarse_mm)),
                    "make the half higher, or the profile lower"});
}

void check_depth(const Half& half, double edge_mm, std::vector<Fault>& faults) {
  if (half.depth_mm == 0.0 || half.depth_mm >= kShortestPiece * edge_mm) return;
  faults.push_back(
      {std::string(half.depth_key), "is no room for a layer of particles", number_text(half.depth_mm),
       fmt::format("0, or at least {} mm, 1.5 times /particles/edge_mm", rounded(kShortestPiece * edge_mm)),
       "enlarge it, or shorten the particles' edges"});
}

void check_room(const Half& half, double coarse_mm, double edge_mm, std::vector<Fault>& faults) {
  const double bare = half.reach_mm + coarse_mm, least = bare + kShortestPiece * edge_mm;
  if (half.depth_mm == 0.0 || half.height_mm < bare || half.height_mm >= least) return;
  faults.push_back({std::string(half.height_key), "leaves no room for a layer of particles",
                    number_text(half.height_mm),
                    fmt::format("at least {} mm: the profile's {} mm, 1.5 particle edges and coarse_edge_mm {}",
                                rounded(least), rounded(half.reach_mm), number_text(coarse_mm)),
                    fmt::format("make the half higher, or set {} to 0", half.depth_key)});
}

/// A straight piece of the profile: the key it comes from, and what it is called.
struct Piece {
  std::string where, name;
  double length_mm;
};

std::vector<Piece> pieces_of_teeth(const JointConfig& joint) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < joint.profile.size(); ++i) {
    const ToothConfig& tooth = joint.profile[i];
    const std::string at = fmt::format("/joint/profile/{}", i);
    pieces.push_back({at + "/gap_before_mm", "gap", tooth.gap_before_mm});
    pieces.push_back({at + "/height_mm", "flank", tooth.height_mm / std::sin(tooth.angle_deg * units::kRadPerDeg)});
  }
  pieces.push_back({"/joint/end_gap_mm", "gap", joint.end_gap_mm});
  return pieces;
}

/// Of the merged profile; each is named by the given point at its end.
std::vector<Piece> pieces_of_points(const std::vector<Vec2>& given, const JointProfile& profile) {
  std::vector<Piece> pieces;
  std::size_t point = 0;
  for (std::size_t i = 1; i < profile.points.size(); ++i) {
    const Vec2 corner = profile.points[i];
    while (given[point].x - given.front().x < corner.x) ++point;
    pieces.push_back(
        {fmt::format("/joint/points_mm/{}", point), "piece before this point", norm(corner - profile.points[i - 1])});
  }
  return pieces;
}

/// Names the shortest of a rough profile's many pieces only.
void check_pieces(const JointConfig& joint, const JointProfile& profile, double edge_mm, std::vector<Fault>& faults) {
  const double least = kShortestPiece * edge_mm;
  const bool rough = !joint.points_mm.empty();
  std::vector<Piece> pieces = rough ? pieces_of_points(joint.points_mm, profile) : pieces_of_teeth(joint);
  std::erase_if(pieces, [&](const Piece& p) { return p.length_mm >= least || (!rough && p.length_mm == 0.0); });
  if (rough && pieces.size() > 1) {
    const auto shorter = [](const Piece& a, const Piece& b) { return a.length_mm < b.length_mm; };
    Piece shortest = *std::min_element(pieces.begin(), pieces.end(), shorter);
    shortest.name += fmt::format(" (the shortest of {} such pieces)", pieces.size());
    pieces = {shortest};
  }
  for (const Piece& piece : pieces)
    faults.push_back(
        {piece.where, "a tooth finer than the particles' edge: the " + piece.name + " is too short",
         rounded(piece.length_mm) + " mm long",
         fmt::format("at least {} mm, 1.5 times /particles/edge_mm {}", rounded(least), number_text(edge_mm)),
         rough ? "leave points out, or shorten the particles' edges"
               : "enlarge it, or shorten the particles' edges (a gap may also be 0)"});
}

double sharpest_foot_deg(const JointProfile& profile) {
  double sharpest = 90.0;
  for (std::size_t i = 1; i < profile.points.size(); ++i) {
    const Vec2 a = profile.points[i - 1], b = profile.points[i];
    if ((a.y == profile.lowest()) == (b.y == profile.lowest())) continue;
    sharpest = std::min(sharpest, std::atan2(std::abs(b.y - a.y), b.x - a.x) / units::kRadPerDeg);
  }
  return sharpest;
}

double thinnest_mm(const JointProfile& profile) {
  double thinnest = std::numeric_limits<double>::infinity();
  for (const Vec2& p : profile.points)
    if (p.y > profile.lowest()) thinnest = std::min(thinnest, p.y - profile.lowest());
  return thinnest;
}

/// Without a damage depth the lower particles fill the teeth alone, down to the profile's lowest points.
void check_feet(const JointConfig& joint, const JointProfile& profile, double edge_mm, std::vector<Fault>& faults) {
  if (joint.damage_depth_lower_mm > 0.0) return;
  const auto add = [&](std::string what, std::string allowed) {
    faults.push_back({"/joint/damage_depth_lower_mm", std::move(what), "0", std::move(allowed),
                      "give the particles a depth below the teeth"});
  };
  const double foot = sharpest_foot_deg(profile), thin = thinnest_mm(profile);
  if (foot < kSharpestFootDeg - kRounding)
    add(fmt::format("particles cannot fill the teeth alone, down to feet of {} degrees", rounded(foot)),
        "above 0 mm where teeth rise at less than 12 degrees from the profile's lowest point");
  if (thin < kShortestPiece * edge_mm)
    add(fmt::format("particles cannot fill the teeth alone where they are {} mm thin", rounded(thin)),
        fmt::format("above 0 mm where a corner is less than {} mm, 1.5 particle edges, above the lowest point",
                    rounded(kShortestPiece * edge_mm)));
}

void check_kind(const ParticleConfig& particles, std::vector<Fault>& faults) {
  if (particles.kind == ParticleKind::triangle) return;
  faults.push_back(
      {"/particles/kind", "a joint's particles are triangles", "\"voronoi\"", "\"triangle\"", "remove the key"});
}

void check_coarse_edge(const JointConfig& joint, double edge_mm, std::vector<Fault>& faults) {
  if (joint.coarse_edge_mm >= edge_mm) return;
  faults.push_back({"/joint/coarse_edge_mm", "is shorter than the particles' edges", number_text(joint.coarse_edge_mm),
                    "at least /particles/edge_mm " + number_text(edge_mm),
                    "lengthen it, or shorten the particles' edges"});
}

}  // namespace

std::vector<Fault> profile_faults(const JointConfig& joint) {
  std::vector<Fault> faults;
  if (joint.points_mm.empty())
    check_teeth(joint, faults);
  else
    check_points(joint.points_mm, faults);
  return faults;
}

std::vector<Fault> joint_faults(const JointConfig& joint, const ParticleConfig& particles) {
  std::vector<Fault> faults = profile_faults(joint);
  const bool has_profile = faults.empty();
  check_kind(particles, faults);
  check_coarse_edge(joint, particles.edge_mm, faults);
  if (!has_profile) return faults;
  const JointProfile profile = joint_profile(joint);
  for (const Half& half : halves(joint, profile)) {
    check_height(half, joint.coarse_edge_mm, faults);
    check_depth(half, particles.edge_mm, faults);
    check_room(half, joint.coarse_edge_mm, particles.edge_mm, faults);
  }
  check_pieces(joint, profile, particles.edge_mm, faults);
  check_feet(joint, profile, particles.edge_mm, faults);
  return faults;
}

}  // namespace asperity
