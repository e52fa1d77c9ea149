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
  const double share = 1.0 / gauge.strips.count;
  for (std::size_t t = 0; t < general.touches.size(); ++t) {
    const MemberPair& pair = general.pairs[general.touches[t].pair];
    const int a = general.members[pair.a].triangle, b = general.members[pair.b].triangle;
    if (gauge.lower[a] == gauge.lower[b]) continue;
    const int flank = gauge.flank_of_triangle[gauge.lower[a] ? a : b];
    if (flank < 0) continue;
    const std::size_t upper = gauge.lower[a] ? 3 : 0;
    ToothReading& tooth = reading.teeth[flank / 2];
    Vec2& force = flank % 2 ? tooth.leading : tooth.trailing;
    for (std::size_t i = 0; i < 3; ++i) force += share * general.forces[t][upper + i];
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
  std::array<double, kMostTeeth> attached{};
  for (std::size_t t = 0; t < gauge.flank_of_triangle.size(); ++t) {
    const int flank = gauge.flank_of_triangle[t];
    const int body = gauge.bodies[gauge.strips.of(t)];
    if (flank >= 0 && fragments.of_triangle[t] == fragments.of_triangle[body])
      attached[flank / 2] += system.particles.shape(t).area;
  }
  for (std::size_t i = 0; i < gauge.tooth_area_mm2.size(); ++i) {
    reading.teeth[i].attached_share = attached[i] / gauge.tooth_area_mm2[i];
  }
}

/// Corners of a triangle of an upper half that stand on its rear or front end, at these x.
void add_end_nodes(const Particles& p, std::size_t t, const std::array<double, 2>& ends, JointGauge& gauge) {
  for (int node : p.triangles[t]) {
    for (std::size_t end = 0; end < 2; ++end) {
      if (p.reference(node).x == ends[end]) gauge.ends[end].push_back(node);
    }
  }
}

}  // namespace

DilationReading& DilationReading::operator-=(const DilationReading& o) {
  mean -= o.mean;
  front -= o.front;
  rear -= o.rear;
  return *this;
}

JointGauge make_joint_gauge(const Particles& p, const JointProfile& profile, const JointStrips& strips,
                            std::vector<std::uint8_t> lower) {
  JointGauge gauge;
  gauge.lower = std::move(lower);
  gauge.strips = strips;
  gauge.bodies.assign(strips.count, -1);
  gauge.tooth_area_mm2.assign(std::min(profile.teeth.size(), kMostTeeth), 0.0);
  for (std::size_t t = 0; t < p.triangle_count(); ++t) {
    const Vec2 in_strip = centroid(p, t) - Vec2{0.0, strips.plane(strips.of(t))};
    const int flank = gauge.lower[t] ? flank_at(profile, in_strip) : -1;
    gauge.flank_of_triangle.push_back(flank);
    if (flank >= 0) gauge.tooth_area_mm2[flank / 2] += p.shape(t).area;
    if (gauge.lower[t]) {
      int& body = gauge.bodies[strips.of(t)];
      if (body < 0 || centroid(p, t).y < centroid(p, body).y) body = static_cast<int>(t);
    } else {
      add_end_nodes(p, t, {strips.upper_shift.x, strips.upper_shift.x + profile.length()}, gauge);
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
