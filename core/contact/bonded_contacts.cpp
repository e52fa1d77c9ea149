#include "core/contact/bonded_contacts.hpp"

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

template <class UpdatePoint>
void update_edges(BondedContacts& contacts, const std::vector<Vec2>& position, double time, const ParallelLoops& loops,
                  std::span<Vec2> forces, const UpdatePoint& update_point) {
  loops.for_blocks(contacts.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      const ContactFrame frame = contact_frame(contacts.edges[c], position);
      auto& points = contacts.points[c];
      EdgeTraction sum;
      add_point(sum, points[0], frame, kNearGauss, kFarGauss, update_point);
      add_point(sum, points[1], frame, kFarGauss, kNearGauss, update_point);
      write_forces(sum, frame, 0.5 * contacts.edges[c].length, &forces[4 * c]);
      if (contacts.break_time[c] < 0.0 && edge_break_mode(points) != BreakMode::none) contacts.break_time[c] = time;
    }
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
  return contacts;
}

void update_contacts(BondedContacts& contacts, const std::vector<Vec2>& position, double time,
                     const ParallelLoops& loops, std::span<Vec2> forces) {
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
