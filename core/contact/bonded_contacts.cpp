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

/// Traction (MPa) times half the edge's area, gathered at both ends, and the couple that the rotating frame needs.
template <class UpdatePoint>
std::array<Vec2, 4> edge_forces(const ContactEdge& edge, std::array<PointState, 2>& points, const ContactFrame& frame,
                       const UpdatePoint& update_point) {
  constexpr double weight[2][2] = {{kNearGauss, kFarGauss}, {kFarGauss, kNearGauss}};
  Vec2 end[2] = {};
  double moment = 0.0;
  for (int q = 0; q < 2; ++q) {
    const Vec2 gap = weight[q][0] * frame.gap[0] + weight[q][1] * frame.gap[1];
    PointState& point = points[q];
    update_point(point, dot(gap, frame.normal), dot(gap, frame.tangent));
    const Vec2 traction = point.traction_n * frame.normal + point.traction_s * frame.tangent;
    for (int i = 0; i < 2; ++i) end[i] += weight[q][i] * traction;
    moment += point.traction_n * point.shear - point.traction_s * point.normal;
  }
  const double area = 0.5 * edge.length;
  const Vec2 couple = (0.5 * area * moment / frame.midline_length) * frame.normal;
  const Vec2 f1 = area * end[0];
  const Vec2 f2 = area * end[1];
  return {f1 - couple, f2 + couple, Vec2{} - f1 - couple, couple - f2};
}

template <class UpdatePoint>
void update_edges(BondedContacts& contacts, const std::vector<Vec2>& position, double time,
                  const ParallelLoops& loops, std::span<Vec2> forces, const UpdatePoint& update_point) {
  loops.for_blocks(contacts.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      const ContactEdge& edge = contacts.edges[c];
      const auto force = edge_forces(edge, contacts.points[c], contact_frame(edge, position), update_point);
      if (contacts.break_time[c] < 0.0 && edge_break_mode(contacts.points[c]) != BreakMode::none) contacts.break_time[c] = time;
      std::copy(force.begin(), force.end(), forces.begin() + 4 * static_cast<std::ptrdiff_t>(c));
    }
  });
}

}  // namespace

BondedContacts make_contacts(const Mesh& mesh, const Particles& particles, const LawParameters& law, LawReading reading) {
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
  return contacts;
}

ContactFrame contact_frame(const ContactEdge& edge, const std::vector<Vec2>& x) {
  const Vec2 l1 = x[edge.left1], l2 = x[edge.left2], r1 = x[edge.right1], r2 = x[edge.right2];
  const Vec2 midline = 0.5 * ((l2 - l1) + (r2 - r1));
  const double length = norm(midline);
  const Vec2 tangent = (1.0 / length) * midline;
  return {tangent, {tangent.y, -tangent.x}, length, {r1 - l1, r2 - l2}};
}

void update_contacts(BondedContacts& contacts, const std::vector<Vec2>& position, double time, const ParallelLoops& loops,
                     std::span<Vec2> forces) {
  const LawParameters& law = contacts.law;
  if (contacts.reading == LawReading::literal) {
    update_edges(contacts, position, time, loops, forces,
                 [&law](PointState& s, double n, double t) { literal_law::update(s, n, t, law); });
  } else {
    update_edges(contacts, position, time, loops, forces,
                 [&law](PointState& s, double n, double t) { consistent_law::update(s, n, t, law); });
  }
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
      for (const PointState& s : contacts.points[c]) {
        const double recoverable = contacts.reading == LawReading::literal
                                       ? literal_law::recoverable_energy(s, contacts.law)
                                       : consistent_law::recoverable_energy(s, contacts.law);
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
