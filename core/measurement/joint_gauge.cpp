#include "core/measurement/joint_gauge.hpp"

#include <algorithm>

#include "core/measurement/fragments.hpp"

namespace asperity {
namespace {

Vec2 centroid(const Particles& p, std::size_t t) {
  Vec2 sum;
  for (int node : p.triangles[t]) sum += p.reference(node);
  return (1.0 / 3.0) * sum;
}

/// The flank of the tooth that a point at rest lies in, -1: it lies in none.
int flank_at(const JointProfile& profile, Vec2 point) {
  if (point.y <= 0.0) return -1;
  const std::size_t teeth = std::min(profile.teeth.size(), kMostTeeth);
  for (std::size_t i = 0; i < teeth; ++i) {
    const ToothSpan& tooth = profile.teeth[i];
    if (point.x >= tooth.begin_mm && point.x <= tooth.end_mm) {
      return static_cast<int>(2 * i) + (point.x > tooth.crest_mm ? 1 : 0);
    }
  }
  return -1;
}

double mean_rise(const std::vector<int>& nodes, const Particles& p) {
  double sum = 0.0;
  for (int node : nodes) sum += p.position[node].y - p.reference(node).y;
  return nodes.empty() ? 0.0 : sum / static_cast<double>(nodes.size());
}

/// Forces across the joint, by the flank on which the lower half bears them; Eq. (M32).
void add_flank_forces(const JointGauge& gauge, const System& system, JointReading& reading) {
  const GeneralContacts& general = system.general;
  for (std::size_t t = 0; t < general.touches.size(); ++t) {
    const MemberPair& pair = general.pairs[general.touches[t].pair];
    const int a = general.members[pair.a].triangle, b = general.members[pair.b].triangle;
    if (gauge.lower[a] == gauge.lower[b]) continue;
    const int flank = gauge.flank_of_triangle[gauge.lower[a] ? a : b];
    if (flank < 0) continue;
    const std::size_t upper = gauge.lower[a] ? 3 : 0;
    ToothReading& tooth = reading.teeth[flank / 2];
    Vec2& force = flank % 2 ? tooth.leading : tooth.trailing;
    for (std::size_t i = 0; i < 3; ++i) force += general.forces[t][upper + i];
  }
}

/// Eq. (M33).
void add_damage(const JointGauge& gauge, const System& system, JointReading& reading) {
  const BondedContacts& contacts = system.contacts;
  bool any = false;
  for (const BrokenEdge& edge : contacts.broken) any = any || edge.break_time >= 0.0;
  if (!any) return;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const int flank = gauge.flank_of_triangle[contacts.edges[c].left_triangle()];
    if (flank >= 0 && contacts.is_crack(c)) ++reading.teeth[flank / 2].cracks;
  }
  const Fragments fragments = find_fragments(contacts, system.particles);
  const int body = fragments.of_triangle[gauge.body];
  std::array<double, kMostTeeth> attached{};
  for (std::size_t t = 0; t < gauge.flank_of_triangle.size(); ++t) {
    const int flank = gauge.flank_of_triangle[t];
    if (flank >= 0 && fragments.of_triangle[t] == body) attached[flank / 2] += system.particles.shape(t).area;
  }
  for (std::size_t i = 0; i < gauge.tooth_area_mm2.size(); ++i) {
    reading.teeth[i].attached_share = attached[i] / gauge.tooth_area_mm2[i];
  }
}

}  // namespace

DilationReading& DilationReading::operator-=(const DilationReading& o) {
  mean -= o.mean;
  front -= o.front;
  rear -= o.rear;
  return *this;
}

JointGauge make_joint_gauge(const Particles& p, const JointProfile& profile, std::vector<std::uint8_t> lower) {
  JointGauge gauge;
  gauge.lower = std::move(lower);
  gauge.tooth_area_mm2.assign(std::min(profile.teeth.size(), kMostTeeth), 0.0);
  for (std::size_t t = 0; t < p.triangle_count(); ++t) {
    const int flank = gauge.lower[t] ? flank_at(profile, centroid(p, t)) : -1;
    gauge.flank_of_triangle.push_back(flank);
    if (flank >= 0) gauge.tooth_area_mm2[flank / 2] += p.shape(t).area;
    if (gauge.lower[t] && centroid(p, t).y < centroid(p, gauge.body).y) gauge.body = static_cast<int>(t);
    if (gauge.lower[t]) continue;
    for (int node : p.triangles[t]) {
      if (p.reference(node).x == 0.0) gauge.ends[0].push_back(node);
      if (p.reference(node).x == profile.length()) gauge.ends[1].push_back(node);
    }
  }
  return gauge;
}

DilationReading read_dilation(const JointGauge& gauge, const System& system) {
  return {system.blocks.back().displacement.y, mean_rise(gauge.ends[1], system.particles),
          mean_rise(gauge.ends[0], system.particles)};
}

JointReading read_joint(const JointGauge& gauge, const System& system) {
  JointReading reading;
  reading.dilation = read_dilation(gauge, system);
  add_flank_forces(gauge, system, reading);
  add_damage(gauge, system, reading);
  return reading;
}

}  // namespace asperity
