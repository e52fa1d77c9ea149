#include "core/contact/bonded_contacts.hpp"

#include <algorithm>

#include "core/contact/consistent_law.hpp"
#include "core/contact/literal_law.hpp"

namespace asperity {
namespace {

int node_at(const Particles& particles, int triangle, int vertex) {
  for (int node : particles.triangles[triangle]) {
    if (particles.vertex[node] == vertex) return node;
  }
  return -1;
}

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
void write_forces(const EdgeTraction& sum, const ContactFrame& frame, double area, Vec2* forces) {
  const double couple = 0.5 * area * sum.moment / frame.midline_length;
  const Vec2 n = frame.normal;
  const Vec2 t = frame.tangent;
  const Vec2 f1 = (area * sum.n1) * n + (area * sum.s1) * t;
  const Vec2 f2 = (area * sum.n2) * n + (area * sum.s2) * t;
  forces[0] = f1 - couple * n;
  forces[1] = f2 + couple * n;
  forces[2] = (-couple) * n - f1;
  forces[3] = couple * n - f2;
}

/// The law of a contact whose normal stiffness has the weight w.
LawParameters weighted(const LawParameters& law, double weight) {
  LawParameters result = law;
  result.k_t *= weight;
  return result;
}

/// Mean separation of a contact edge along its normal and its tangent, mm.
struct MeanGap {
  double opening, slip;
};

MeanGap mean_gap(const ContactFrame& frame) {
  const Vec2 gap = 0.5 * (frame.gap[0] + frame.gap[1]);
  return {dot(gap, frame.normal), dot(gap, frame.tangent)};
}

/// Slip and further opening since breakage over the range, squared: xi^2 of Eq. (C44).
double distance_since_breakage(const HandOver& h, MeanGap gap, double range) {
  const double slip = gap.slip - h.slip;
  const double opening = std::max(0.0, gap.opening - h.opening);
  return (slip * slip + opening * opening) / (range * range);
}

/// Eq. (C45).
double hand_over_weight(double distance) { return distance < 1.0 ? (1.0 - distance) * (1.0 - distance) : 0.0; }

/// Lets a contact go: what it still holds is given up as friction.
void release(std::array<PointState, 2>& points, const LawParameters& law) {
  for (PointState& s : points) {
    s.friction_energy += 0.5 * s.friction * s.friction / law.k_s;
    s.friction = s.traction_s = s.traction_n = 0.0;
  }
}

bool broken_contact_stays(const BondedContacts& contacts, std::size_t c) {
  return contacts.break_time[c] >= 0.0 && contacts.hand_over_range > 0.0;
}

/// Play of an end stop over the edge length: far more than faces overlap under stress.
constexpr double kEndPlay = 0.02;

/// Eq. (C53): springs of half a point's stiffness on ends that overlap by more than their play.
void add_end_stops(EdgeTraction& sum, EndStops& stops, const ContactFrame& frame, double length, double k_t,
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

bool point_broken(const std::array<PointState, 2>& points) {
  return points[0].broken != BreakMode::none || points[1].broken != BreakMode::none;
}

template <class UpdatePoint>
void update_edge(BondedContacts& contacts, std::size_t c, const ContactFrame& frame, Vec2* forces,
                 const UpdatePoint& update_point) {
  auto& points = contacts.points[c];
  const double length = contacts.edges[c].length;
  EdgeTraction sum;
  add_point(sum, points[0], frame, kNearGauss, kFarGauss, update_point);
  add_point(sum, points[1], frame, kFarGauss, kNearGauss, update_point);
  if (contacts.hand_over_range > 0.0 && point_broken(points)) {
    add_end_stops(sum, contacts.end_stops[c], frame, length, contacts.law.k_t, contacts.hand_over[c].weight);
  }
  write_forces(sum, frame, 0.5 * length, forces);
}

/// A broken contact with its own pair, or none any more; true when it is released.
template <class Law>
bool update_broken_edge(BondedContacts& contacts, std::size_t c, const std::vector<Vec2>& position, Vec2* forces,
                        const Law& law) {
  HandOver& h = contacts.hand_over[c];
  if (h.weight == 0.0) {
    std::fill_n(forces, 4, Vec2{});
    return false;
  }
  const ContactEdge& edge = contacts.edges[c];
  const ContactFrame frame = contact_frame(edge, position);
  const double range = contacts.hand_over_range * edge.length;
  h.weight = hand_over_weight(distance_since_breakage(h, mean_gap(frame), range));
  if (h.weight == 0.0) {
    release(contacts.points[c], contacts.law);
    std::fill_n(forces, 4, Vec2{});
    return true;
  }
  const LawParameters parameters = weighted(contacts.law, h.weight);
  update_edge(contacts, c, frame, forces, [&](PointState& s, double n, double t) { law(s, n, t, parameters); });
  return false;
}

template <class Law>
int update_edges(BondedContacts& contacts, const std::vector<Vec2>& position, double time, const ParallelLoops& loops,
                 std::span<Vec2> forces, const Law& law) {
  return loops.sum_blocks<int>(contacts.size(), [&](std::size_t begin, std::size_t end) {
    int changes = 0;
    for (std::size_t c = begin; c < end; ++c) {
      if (broken_contact_stays(contacts, c)) {
        changes += update_broken_edge(contacts, c, position, &forces[4 * c], law);
        continue;
      }
      const ContactFrame frame = contact_frame(contacts.edges[c], position);
      update_edge(contacts, c, frame, &forces[4 * c],
                  [&](PointState& s, double n, double t) { law(s, n, t, contacts.law); });
      if (contacts.break_time[c] < 0.0 && edge_break_mode(contacts.points[c]) != BreakMode::none) {
        contacts.break_time[c] = time;
        const MeanGap gap = mean_gap(frame);
        contacts.hand_over[c] = {std::max(0.0, gap.opening), gap.slip, 1.0};
        ++changes;
      }
    }
    return changes;
  });
}

}  // namespace

BondedContacts make_contacts(const Mesh& mesh, const Particles& particles, const LawParameters& law,
                             LawReading reading) {
  BondedContacts contacts;
  contacts.law = law;
  contacts.reading = reading;
  for (const MeshEdge& edge : mesh_edges(mesh)) {
    if (edge.right < 0 || mesh.grain[edge.left] == mesh.grain[edge.right]) continue;
    contacts.edges.push_back({node_at(particles, edge.left, edge.a), node_at(particles, edge.left, edge.b),
                              node_at(particles, edge.right, edge.a), node_at(particles, edge.right, edge.b), edge.left,
                              edge.right, norm(mesh.vertices[edge.b] - mesh.vertices[edge.a])});
  }
  contacts.points.resize(contacts.edges.size());
  contacts.break_time.assign(contacts.edges.size(), -1.0);
  contacts.hand_over.resize(contacts.edges.size());
  contacts.end_stops.resize(contacts.edges.size());
  return contacts;
}

int update_contacts(BondedContacts& contacts, const std::vector<Vec2>& position, double time,
                    const ParallelLoops& loops, std::span<Vec2> forces) {
  if (contacts.reading == LawReading::literal) {
    return update_edges(
        contacts, position, time, loops, forces,
        [](PointState& s, double n, double t, const LawParameters& p) { literal_law::update(s, n, t, p); });
  }
  return update_edges(
      contacts, position, time, loops, forces,
      [](PointState& s, double n, double t, const LawParameters& p) { consistent_law::update(s, n, t, p); });
}

void add_hand_over_force(const BondedContacts& contacts, std::size_t c, double general_energy,
                         const std::vector<Vec2>& position, Vec2* forces) {
  const HandOver& h = contacts.hand_over[c];
  const ContactEdge& edge = contacts.edges[c];
  const ContactFrame frame = contact_frame(edge, position);
  const MeanGap gap = mean_gap(frame);
  const double range = contacts.hand_over_range * edge.length;
  const double distance = distance_since_breakage(h, gap, range);
  if (distance == 0.0 || distance >= 1.0) return;
  double own_energy = contacts.end_stops[c].energy;
  for (const PointState& s : contacts.points[c]) {
    const double closed = std::min(0.0, s.normal);
    own_energy += 0.25 * edge.length * contacts.law.k_t * closed * closed;
  }
  const double slope = -4.0 * (1.0 - distance) / (range * range) * (own_energy - general_energy);
  const double along_normal = slope * std::max(0.0, gap.opening - h.opening);
  const double along_tangent = slope * (gap.slip - h.slip);
  EdgeTraction sum{0.5 * along_normal, 0.5 * along_tangent, 0.5 * along_normal, 0.5 * along_tangent,
                   along_normal * gap.slip - along_tangent * gap.opening};
  std::array<Vec2, 4> added;
  write_forces(sum, frame, 1.0, added.data());
  for (int i = 0; i < 4; ++i) forces[i] += added[i];
}

ContactEnergies& ContactEnergies::operator+=(const ContactEnergies& other) {
  recoverable += other.recoverable;
  fracture += other.fracture;
  friction += other.friction;
  created += other.created;
  return *this;
}

ContactEnergies contact_energies(const BondedContacts& contacts, const ParallelLoops& loops) {
  return loops.sum_blocks<ContactEnergies>(contacts.size(), [&](std::size_t begin, std::size_t end) {
    ContactEnergies sum;
    for (std::size_t c = begin; c < end; ++c) {
      const double area = 0.5 * contacts.edges[c].length;
      const bool released = contacts.hand_over[c].weight == 0.0;
      const LawParameters law = weighted(contacts.law, contacts.hand_over[c].weight);
      if (!released) sum.recoverable += contacts.hand_over[c].weight * contacts.end_stops[c].energy;
      for (const PointState& s : contacts.points[c]) {
        const double recoverable = released ? 0.0
                                   : contacts.reading == LawReading::literal
                                       ? literal_law::recoverable_energy(s, law)
                                       : consistent_law::recoverable_energy(s, law);
        sum += {area * recoverable, area * s.fracture_energy, area * s.friction_energy, area * s.created_energy};
      }
    }
    return sum;
  });
}

BreakMode edge_break_mode(const std::array<PointState, 2>& points) {
  if (points[0].broken == BreakMode::none || points[1].broken == BreakMode::none) return BreakMode::none;
  return points[0].fracture_energy >= points[1].fracture_energy ? points[0].broken : points[1].broken;
}

double edge_damage(const std::array<PointState, 2>& points) {
  const auto damage = [](const PointState& s) { return s.broken != BreakMode::none ? 1.0 : s.damage; };
  return 0.5 * (damage(points[0]) + damage(points[1]));
}

}  // namespace asperity
