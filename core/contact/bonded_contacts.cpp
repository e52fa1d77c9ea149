#include "core/contact/bonded_contacts.hpp"

#include <algorithm>

#include "core/contact/edge_update.hpp"

namespace asperity {
namespace {

/// The corner of a triangle at a mesh vertex.
int corner_at(const Particles& particles, int triangle, int vertex) {
  for (int k = 0; k < 3; ++k) {
    if (particles.vertex[particles.triangles[triangle][k]] == vertex) return k;
  }
  return -1;
}

ContactEdge make_edge(const Mesh& mesh, const Particles& particles, const MeshEdge& edge) {
  const int left = corner_at(particles, edge.left, edge.a), right = corner_at(particles, edge.right, edge.b);
  const auto& l = particles.triangles[edge.left];
  const auto& r = particles.triangles[edge.right];
  return {l[left],
          l[(left + 1) % 3],
          r[(right + 1) % 3],
          r[right],
          3 * edge.left + left,
          3 * edge.right + right,
          norm(mesh.vertices[edge.b] - mesh.vertices[edge.a])};
}

/// Slot of an edge inside a grain, or the edge that such a slot names: the code is its own inverse.
int grain_slot(int edge) { return -2 - edge; }

}  // namespace

BondedContacts make_contacts(const Mesh& mesh, const Particles& particles, const LawParameters& law, LawReading reading,
                             LawForm form) {
  BondedContacts contacts;
  contacts.law = law;
  contacts.reading = reading;
  contacts.form = form;
  contacts.slot_of_edge.assign(3 * mesh.triangles.size(), -1);
  std::vector<int> outline;
  for (const MeshEdge& edge : mesh_edges(mesh)) {
    const int left = 3 * edge.left + corner_at(particles, edge.left, edge.a);
    if (edge.right < 0) {
      outline.push_back(left);
      continue;
    }
    const int right = 3 * edge.right + corner_at(particles, edge.right, edge.b);
    if (mesh.grain[edge.left] == mesh.grain[edge.right]) {
      contacts.slot_of_edge[left] = grain_slot(right);
      contacts.slot_of_edge[right] = grain_slot(left);
      continue;
    }
    contacts.slot_of_edge[left] = static_cast<int>(contact_slot(contacts.size(), 0));
    contacts.slot_of_edge[right] = static_cast<int>(contact_slot(contacts.size(), 1));
    contacts.edges.push_back(make_edge(mesh, particles, edge));
  }
  contacts.edges.shrink_to_fit();
  contacts.outline_edges = outline.size();
  const std::size_t first = contact_slot_count(contacts.size());
  for (std::size_t i = 0; i < outline.size(); ++i) contacts.slot_of_edge[outline[i]] = static_cast<int>(first + i);
  contacts.memory = ContactPoints(contacts.size(), reading == LawReading::consistent);
  contacts.broken_index.assign(contacts.size(), -1);
  return contacts;
}

std::array<PointState, 2> BondedContacts::points(std::size_t c) const {
  std::array<PointState, 2> result = memory.load(c);
  if (reading == LawReading::literal) return result;
  const int index = broken_index[c];
  const LawParameters present = edge_update::weighted(law_of(*this, c), weight(c));
  for (std::size_t q = 0; q < 2; ++q) {
    if (index >= 0) result[q].broken = broken[index].points[q];
    consistent_law::set_traction(result[q], present);
  }
  return result;
}

void BondedContacts::set_points(std::size_t c, const std::array<PointState, 2>& points) {
  memory.store(c, points);
  const std::array<BreakMode, 2> modes{points[0].broken, points[1].broken};
  if (broken_index[c] >= 0 || modes != std::array{BreakMode::none, BreakMode::none}) broken_edge(c).points = modes;
}

double BondedContacts::strength(std::size_t c) const {
  return strengths.empty() ? 1.0 : strengths[c / kPacked].factor[c % kPacked];
}

double BondedContacts::break_time(std::size_t c) const {
  return broken_index[c] < 0 ? -1.0 : broken[broken_index[c]].break_time;
}

bool BondedContacts::is_defect(std::size_t c) const {
  return broken_index[c] >= 0 && broken[broken_index[c]].defect == 1;
}

double BondedContacts::weight(std::size_t c) const {
  return broken_index[c] < 0 ? 1.0 : broken[broken_index[c]].hand_over.weight;
}

BrokenEdge& BondedContacts::broken_edge(std::size_t c) {
  if (broken_index[c] < 0) {
    broken_index[c] = static_cast<int>(broken.size());
    broken.emplace_back();
  }
  return broken[broken_index[c]];
}

int BondedContacts::joint(int edge) const {
  const int slot = slot_of_edge[edge];
  if (slot < 0) return kGrain;
  return static_cast<std::size_t>(slot) < contact_slot_count(size()) ? static_cast<int>(contact_of_slot(slot))
                                                                     : kOutline;
}

int BondedContacts::partner(int edge) const {
  const int contact = joint(edge);
  if (contact == kGrain) return grain_slot(slot_of_edge[edge]);
  if (contact == kOutline) return -1;
  return edges[contact].left_edge == edge ? edges[contact].right_edge : edges[contact].left_edge;
}

void set_strengths(BondedContacts& contacts, const std::vector<double>& factors) {
  contacts.strengths.assign((contacts.size() + kPacked - 1) / kPacked, StrengthRow{});
  for (StrengthRow& row : contacts.strengths) row.factor.fill(1.0);
  for (std::size_t c = 0; c < factors.size(); ++c) contacts.strengths[c / kPacked].factor[c % kPacked] = factors[c];
}

LawParameters law_of(const BondedContacts& contacts, std::size_t c) {
  return contacts.strengths.empty() ? contacts.law : scaled(contacts.law, contacts.strength(c));
}

void open_from_start(BondedContacts& contacts, std::size_t c) {
  std::array<PointState, 2> points = contacts.memory.load(c);
  for (PointState& s : points) {
    s.damage = 1.0;
    s.integrity_n = s.integrity_s = 0.0;
    s.broken = BreakMode::tension;
  }
  contacts.set_points(c, points);
  BrokenEdge& broken = contacts.broken_edge(c);
  broken.break_time = 0.0;
  broken.defect = 1;
}

void add_hand_over_force(const BondedContacts& contacts, std::size_t c, double general_energy,
                         const std::vector<Vec2>& position, std::span<Vec2> forces) {
  using namespace edge_update;
  const BrokenEdge& broken = contacts.broken[contacts.broken_index[c]];
  const HandOver& h = broken.hand_over;
  const ContactEdge& edge = contacts.edges[c];
  const ContactFrame frame = contact_frame(edge, position);
  const MeanGap gap = mean_gap(frame);
  const double range = contacts.hand_over_range * edge.length;
  const double distance = distance_since_breakage(h, gap, range);
  if (distance == 0.0 || distance >= 1.0) return;
  double own_energy = broken.end_stops.energy;
  const LawParameters of_point =
      weighted(contacts.law, 0.5 * edge.length);  // its energies are N mm per mm of thickness
  for (const PointState& s : contacts.memory.load(c)) {
    if (s.normal < 0.0) own_energy += consistent_law::closing_energy(s.normal, of_point);
  }
  const double slope = -4.0 * (1.0 - distance) / (range * range) * (own_energy - general_energy);
  const double along_normal = slope * std::max(0.0, gap.opening - h.opening);
  const double along_tangent = slope * (gap.slip - h.slip);
  add_forces({0.5 * along_normal, 0.5 * along_tangent, 0.5 * along_normal, 0.5 * along_tangent,
              along_normal * gap.slip - along_tangent * gap.opening},
             frame, 1.0, c, forces);
}

ContactEnergies& ContactEnergies::operator+=(const ContactEnergies& other) {
  recoverable += other.recoverable;
  fracture += other.fracture;
  friction += other.friction;
  created += other.created;
  return *this;
}

namespace {

ContactEnergies edge_energies(const BondedContacts& contacts, std::size_t c) {
  const double area = 0.5 * contacts.edges[c].length, weight = contacts.weight(c);
  const LawParameters law = edge_update::weighted(law_of(contacts, c), weight);
  ContactEnergies sum;
  if (contacts.broken_index[c] >= 0) {
    sum.recoverable = weight * contacts.broken[contacts.broken_index[c]].end_stops.energy;
  }
  for (const PointState& s : contacts.memory.load(c)) {
    const double recoverable = weight == 0.0                             ? 0.0
                               : contacts.reading == LawReading::literal ? literal_law::recoverable_energy(s, law)
                                                                         : consistent_law::recoverable_energy(s, law);
    sum += {area * recoverable, area * s.fracture_energy, area * s.friction_energy, area * s.created_energy};
  }
  return sum;
}

}  // namespace

ContactEnergies contact_energies(const BondedContacts& contacts, const ParallelLoops& loops) {
  return loops.sum_blocks<ContactEnergies>(contacts.size(), [&](std::size_t begin, std::size_t end) {
    ContactEnergies sum;
    for (std::size_t c = begin; c < end; ++c) sum += edge_energies(contacts, c);
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
