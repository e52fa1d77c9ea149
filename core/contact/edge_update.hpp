#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/contact/bonded_contacts.hpp"
#include "core/contact/consistent_law.hpp"
#include "core/contact/literal_law.hpp"

/// One contact edge at a time: the reference of the fast kernel, and what that leaves to it (broken edges). Internal to
/// core/contact.
namespace asperity::edge_update {

/// Tractions (MPa) of the two points, gathered at both ends, and the couple that the rotating frame needs.
struct EdgeTraction {
  double n1 = 0, s1 = 0, n2 = 0, s2 = 0;  ///< Normal and tangential at ends 1 and 2.
  double moment = 0;                      ///< Of both points, per unit of area.
};

template <class UpdatePoint>
void add_point(EdgeTraction& sum, PointState& point, const ContactFrame& frame, double w1, double w2,
               const UpdatePoint& update_point) {
  const Vec2 gap = w1 * frame.gap[0] + w2 * frame.gap[1];
  update_point(point, dot(gap, frame.normal), dot(gap, frame.tangent));
  sum.n1 += w1 * point.traction_n;
  sum.s1 += w1 * point.traction_s;
  sum.n2 += w2 * point.traction_n;
  sum.s2 += w2 * point.traction_s;
  sum.moment += point.traction_n * point.shear - point.traction_s * point.normal;
}

/// Eqs. (C17), (C18).
inline void add_forces(const EdgeTraction& sum, const ContactFrame& frame, double area, std::size_t contact,
                       std::span<Vec2> forces) {
  const double couple = 0.5 * area * sum.moment / frame.midline_length;
  const Vec2 n = frame.normal;
  const Vec2 t = frame.tangent;
  const Vec2 f1 = (area * sum.n1) * n + (area * sum.s1) * t;
  const Vec2 f2 = (area * sum.n2) * n + (area * sum.s2) * t;
  forces[force_index(contact, ContactNode::left1)] += f1 - couple * n;
  forces[force_index(contact, ContactNode::left2)] += f2 + couple * n;
  forces[force_index(contact, ContactNode::right1)] += (-couple) * n - f1;
  forces[force_index(contact, ContactNode::right2)] += couple * n - f2;
}

inline void write_no_forces(std::size_t contact, std::span<Vec2> forces) {
  for (std::size_t side = 0; side < 2; ++side) {
    const std::size_t at = 2 * contact_slot(contact, side);
    forces[at] = forces[at + 1] = Vec2{};
  }
}

inline void write_forces(const EdgeTraction& sum, const ContactFrame& frame, double area, std::size_t contact,
                         std::span<Vec2> forces) {
  write_no_forces(contact, forces);
  add_forces(sum, frame, area, contact, forces);
}

/// The law of a contact whose normal stiffness has the weight w.
inline LawParameters weighted(const LawParameters& law, double weight) {
  LawParameters result = law;
  result.k_t *= weight;
  return result;
}

/// Mean separation of a contact edge along its normal and its tangent, mm.
struct MeanGap {
  double opening, slip;
};

inline MeanGap mean_gap(const ContactFrame& frame) {
  const Vec2 gap = 0.5 * (frame.gap[0] + frame.gap[1]);
  return {dot(gap, frame.normal), dot(gap, frame.tangent)};
}

/// Slip and further opening since breakage, mm, as Eq. (C44) counts them: of a defect, which the intact rock still
/// holds in place, only what passes the range.
inline MeanGap since_breakage(const BrokenEdge& broken, MeanGap gap, double range) {
  const double play = broken.defect ? range : 0.0, slip = gap.slip - broken.hand_over.slip;
  return {std::max(0.0, gap.opening - broken.hand_over.opening - play),
          std::copysign(std::max(0.0, std::abs(slip) - play), slip)};
}

/// Both over the range, squared: xi^2 of Eq. (C44).
inline double distance_of(MeanGap since, double range) {
  return (since.slip * since.slip + since.opening * since.opening) / (range * range);
}

/// Eq. (C45).
inline double hand_over_weight(double distance) { return distance < 1.0 ? (1.0 - distance) * (1.0 - distance) : 0.0; }

/// Lets a contact go: what it still holds is given up as friction.
inline void release(std::array<PointState, 2>& points, const LawParameters& law) {
  for (PointState& s : points) {
    s.friction_energy += 0.5 * s.friction * s.friction / law.k_s;
    s.friction = s.traction_s = s.traction_n = 0.0;
  }
}

/// Play of an end stop over the edge length: far more than faces overlap under stress.
inline constexpr double kEndPlay = 0.02;

/// Eq. (C53): springs of half a point's stiffness on ends that overlap by more than their play.
inline void add_end_stops(EdgeTraction& sum, EndStops& stops, const ContactFrame& frame, double length, double k_t,
                          double weight) {
  stops.energy = 0.0;
  std::array<double*, 2> traction{&sum.n1, &sum.n2};
  for (int i = 0; i < 2; ++i) {
    const double opening = dot(frame.gap[i], frame.normal);
    if (stops.rest[i] == 0.0) stops.rest[i] = std::min(0.0, opening) - kEndPlay * length;
    const double depth = std::min(0.0, opening - stops.rest[i]);
    stops.energy += 0.5 * (0.25 * length * k_t) * depth * depth;
    *traction[i] += 0.5 * weight * k_t * depth;
    sum.moment += 0.5 * weight * k_t * depth * dot(frame.gap[i], frame.tangent);
  }
}

/// Enters time and mean separation of an edge of which both points are broken.
inline void note_breakage(BrokenEdge& broken, const ContactFrame& frame, double time) {
  const MeanGap gap = mean_gap(frame);
  broken.break_time = time;
  broken.hand_over = {std::max(0.0, gap.opening), gap.slip, 1.0};
}

/// Contact whose edge has begun to break in this step, with the points' modes.
struct Breakage {
  int contact;
  std::array<BreakMode, 2> points;
};

/// Brings an edge of which no point is broken to the present positions; true where one breaks now.
template <class Law>
bool update_whole_edge(BondedContacts& contacts, std::size_t c, const std::vector<Vec2>& position, const Law& law,
                       std::span<Vec2> forces, Breakage& breakage) {
  const double length = contacts.edges[c].length;
  const ContactFrame frame = contact_frame(contacts.edges[c], position);
  std::array<PointState, 2> points = contacts.memory.load(c);
  const LawParameters parameters = law_of(contacts, c);
  const auto update_point = [&](PointState& s, double n, double t) { law(s, n, t, parameters); };
  EdgeTraction sum;
  add_point(sum, points[0], frame, kNearGauss, kFarGauss, update_point);
  add_point(sum, points[1], frame, kFarGauss, kNearGauss, update_point);
  write_forces(sum, frame, 0.5 * length, c, forces);
  contacts.memory.store(c, points);
  breakage = {static_cast<int>(c), {points[0].broken, points[1].broken}};
  return points[0].broken != BreakMode::none || points[1].broken != BreakMode::none;
}

/// The same of an edge on the list of broken ones; `time` (s). True where its second point breaks or it is released.
template <class Law>
bool update_broken_edge(BondedContacts& contacts, std::size_t c, const std::vector<Vec2>& position, double time,
                        const Law& law, std::span<Vec2> forces) {
  BrokenEdge& broken = contacts.broken[contacts.broken_index[c]];
  HandOver& h = broken.hand_over;
  if (h.weight == 0.0) {
    write_no_forces(c, forces);
    return false;
  }
  const ContactEdge& edge = contacts.edges[c];
  const ContactFrame frame = contact_frame(edge, position);
  std::array<PointState, 2> points = contacts.memory.load(c);
  for (std::size_t q = 0; q < 2; ++q) points[q].broken = broken.points[q];
  const bool hands_over = contacts.hand_over_range > 0.0;
  if (broken.break_time >= 0.0 && hands_over) {
    const double range = contacts.hand_over_range * edge.length;
    h.weight = hand_over_weight(distance_of(since_breakage(broken, mean_gap(frame), range), range));
    if (h.weight == 0.0) {
      release(points, contacts.law);
      contacts.memory.store(c, points);
      write_no_forces(c, forces);
      return true;
    }
  }
  const LawParameters parameters = weighted(law_of(contacts, c), h.weight);
  const auto update_point = [&](PointState& s, double n, double t) { law(s, n, t, parameters); };
  EdgeTraction sum;
  add_point(sum, points[0], frame, kNearGauss, kFarGauss, update_point);
  add_point(sum, points[1], frame, kFarGauss, kNearGauss, update_point);
  if (hands_over) add_end_stops(sum, broken.end_stops, frame, edge.length, contacts.law.k_t, h.weight);
  write_forces(sum, frame, 0.5 * edge.length, c, forces);
  contacts.memory.store(c, points);
  broken.points = {points[0].broken, points[1].broken};
  if (broken.break_time >= 0.0 || edge_break_mode(points) == BreakMode::none) return false;
  note_breakage(broken, frame, time);
  return true;
}

}  // namespace asperity::edge_update
