#include "core/measurement/crack_network.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/base/units.hpp"

namespace asperity {
namespace {

bool softening(const std::array<PointState, 2>& points) { return edge_damage(points) > 0.0; }

Crack make_crack(const BondedContacts& contacts, const Particles& p, std::size_t c) {
  const ContactEdge& e = contacts.edges[c];
  const Vec2 a = p.reference(e.left1);
  const Vec2 b = p.reference(e.left2);
  double angle = std::atan2(b.y - a.y, b.x - a.x) / units::kRadPerDeg;
  if (angle < 0.0) angle += 180.0;
  if (angle >= 180.0) angle -= 180.0;
  return {static_cast<int>(c),
          edge_break_mode(contacts.points(c)),
          contacts.break_time(c),
          0.5 * (a + b),
          angle,
          e.length,
          edge_fracture_energy(contacts, c)};
}

CrackSegment make_segment(const BondedContacts& contacts, const Particles& p, std::size_t c) {
  const ContactEdge& e = contacts.edges[c];
  const auto points = contacts.points(c);
  CrackSegment segment;
  const ContactFrame frame = contact_frame(e, p.position);
  const Vec2 gap = 0.5 * (frame.gap[0] + frame.gap[1]);
  const double aside = norm(gap) > e.length ? 0.0 : 0.5;  // once the faces have parted, the crack is the left one's
  segment.a = p.position[e.left1] + aside * frame.gap[0];
  segment.b = p.position[e.left2] + aside * frame.gap[1];
  const auto mode = static_cast<CrackMode>(edge_break_mode(points));
  segment.mode = contacts.is_defect(c) ? CrackMode::defect : mode;
  segment.damage = edge_damage(points);
  segment.opening_mm = dot(gap, frame.normal);
  segment.slip_mm = dot(gap, frame.tangent);
  segment.break_time_s = contacts.break_time(c);
  segment.energy_n_mm = edge_fracture_energy(contacts, c);
  return segment;
}

}  // namespace

std::vector<Crack> list_cracks(const BondedContacts& contacts, const Particles& particles) {
  std::vector<Crack> cracks;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (contacts.is_crack(c)) cracks.push_back(make_crack(contacts, particles, c));
  }
  std::sort(cracks.begin(), cracks.end(), [](const Crack& a, const Crack& b) {
    return std::tie(a.time_s, a.contact) < std::tie(b.time_s, b.contact);
  });
  return cracks;
}

CrackCounts& CrackCounts::operator+=(const CrackCounts& other) {
  tension += other.tension;
  shear += other.shear;
  softening += other.softening;
  return *this;
}

CrackCounts count_cracks(const BondedContacts& contacts, const ParallelLoops& loops) {
  return loops.sum_blocks<CrackCounts>(contacts.size(), [&](std::size_t begin, std::size_t end) {
    CrackCounts counts;
    for (std::size_t c = begin; c < end; ++c) {
      if (contacts.is_defect(c)) continue;
      const BreakMode mode = edge_break_mode(contacts.points(c));
      counts.tension += mode == BreakMode::tension;
      counts.shear += mode == BreakMode::shear;
      counts.softening += mode == BreakMode::none && softening(contacts.points(c));
    }
    return counts;
  });
}

std::vector<CrackSegment> crack_segments(const BondedContacts& contacts, const Particles& particles) {
  std::vector<CrackSegment> segments;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (softening(contacts.points(c))) segments.push_back(make_segment(contacts, particles, c));
  }
  return segments;
}

double edge_fracture_energy(const BondedContacts& contacts, std::size_t c) {
  const auto points = contacts.points(c);
  return 0.5 * contacts.edges[c].length * (points[0].fracture_energy + points[1].fracture_energy);
}

}  // namespace asperity
