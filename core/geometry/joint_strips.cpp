#include "core/geometry/joint_strips.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

bool is_upper(JointZone zone) { return zone == JointZone::upper_particles || zone == JointZone::upper_elastic; }

/// Halves share no vertex, so that those of the upper one can be moved.
void shift_upper_half(JointMesh& joint, Vec2 shift) {
  std::vector<bool> upper(joint.mesh.vertices.size(), false);
  for (std::size_t t = 0; t < joint.zone.size(); ++t) {
    for (int v : joint.mesh.triangles[t]) upper[v] = is_upper(joint.zone[t]);
  }
  for (std::size_t v = 0; v < upper.size(); ++v) {
    if (upper[v]) joint.mesh.vertices[v] += shift;
  }
}

/// Appends a strip's mesh, raised by `rise` mm.
void append(JointMesh& all, const JointMesh& strip, double rise) {
  const int vertices = static_cast<int>(all.mesh.vertices.size());
  const int triangles = static_cast<int>(all.mesh.triangles.size());
  for (const Vec2& v : strip.mesh.vertices) all.mesh.vertices.push_back(v + Vec2{0.0, rise});
  for (auto t : strip.mesh.triangles) {
    for (int& v : t) v += vertices;
    all.mesh.triangles.push_back(t);
  }
  for (int grain : strip.mesh.grain) all.mesh.grain.push_back(grain + triangles);
  all.zone.insert(all.zone.end(), strip.zone.begin(), strip.zone.end());
  all.mesh.outline_area_mm2 += strip.mesh.outline_area_mm2;
}

double pitch(const JointConfig& joint, const JointProfile& profile, double lift) {
  const double dilation = profile.highest() - profile.lowest() + std::abs(lift);
  return joint.lower_height_mm + joint.upper_height_mm + std::abs(lift) + 2.0 * dilation + 4.0 * joint.coarse_edge_mm;
}

}  // namespace

double mismatch_lift(const JointProfile& profile, double gap_mm) {
  std::vector<double> corners{gap_mm, profile.length()};
  for (const Vec2& p : profile.points) {
    for (double x : {p.x, p.x + gap_mm}) {
      if (x > gap_mm && x < profile.length()) corners.push_back(x);
    }
  }
  double lift = profile.height_at(gap_mm) - profile.height_at(0.0);
  for (double x : corners) lift = std::max(lift, profile.height_at(x) - profile.height_at(x - gap_mm));
  return lift;
}

JointAssembly make_joint_strips(const JointConfig& joint, const ParticleConfig& particles, int count, double gap_mm) {
  JointAssembly made;
  JointStrips& strips = made.strips;
  ParticleConfig own = particles;
  for (int s = 0; s < count; ++s, own.seed += kStripSeeds) {
    JointMesh strip = make_joint_mesh(joint, own);
    if (gap_mm != 0.0) {
      strips.upper_shift = {gap_mm, mismatch_lift(strip.profile, gap_mm)};
      shift_upper_half(strip, strips.upper_shift);
    }
    if (count == 1) {
      made.joint = std::move(strip);
      return made;
    }
    strips.count = count;
    strips.pitch_mm = pitch(joint, strip.profile, strips.upper_shift.y);
    made.joint.profile = strip.profile;
    strips.strip.insert(strips.strip.end(), strip.zone.size(), s);
    append(made.joint, strip, strips.plane(s));
  }
  return made;
}

}  // namespace asperity
