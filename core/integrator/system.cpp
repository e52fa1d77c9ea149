#include "core/integrator/system.hpp"

#include <algorithm>

#include "core/integrator/node_motion.hpp"

namespace asperity {
namespace {

/// Index into the forces of every contribution to a node: triangle corners first, then the four nodes of each contact.
template <class Visit>
void for_each_force(const System& system, const Visit& visit) {
  std::size_t corner = 2 * system.contacts.slot_count();
  for (const auto& nodes : system.particles.triangles) {
    for (int node : nodes) visit(node, corner++);
  }
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const ContactEdge& e = system.contacts.edges[c];
    visit(e.left1, force_index(c, ContactNode::left1));
    visit(e.left2, force_index(c, ContactNode::left2));
    visit(e.right1, force_index(c, ContactNode::right1));
    visit(e.right2, force_index(c, ContactNode::right2));
  }
}

void list_gather(System& system) {
  const std::size_t n = system.particles.node_count();
  NodeGather& gather = system.gather;
  gather.begin.assign(n + 1, 0);
  for_each_force(system, [&](int node, std::size_t) { ++gather.begin[node + 1]; });
  for (std::size_t i = 0; i < n; ++i) gather.begin[i + 1] += gather.begin[i];
  gather.index.resize(gather.begin[n]);
  std::vector<int> fill(gather.begin.begin(), gather.begin.end() - 1);
  for_each_force(system, [&](int node, std::size_t index) { gather.index[fill[node]++] = static_cast<int>(index); });
}

}  // namespace

bool corners_written(const System& system) { return system.kernel == Kernel::reference || !system.particles.separate; }

NodeSums& NodeSums::operator+=(const NodeSums& o) {
  for (int i = 0; i < 2; ++i) {
    reaction[i] += o.reaction[i];
    on_blocks[i] += o.on_blocks[i];
  }
  turning += o.turning;
  work_before += o.work_before;
  work_after += o.work_after;
  damping += o.damping;
  platen_friction += o.platen_friction;
  platen_energy += o.platen_energy;
  kinetic += o.kinetic;
  fastest = std::max(fastest, o.fastest);
  return *this;
}

PlatenSpring PlatenSprings::at(std::size_t node) const {
  const auto place = std::lower_bound(nodes.begin(), nodes.end(), static_cast<int>(node));
  return place != nodes.end() && *place == static_cast<int>(node) ? springs[place - nodes.begin()] : other;
}

Vec2 NodeLoads::at(std::size_t node) const {
  const auto place = std::lower_bound(nodes.begin(), nodes.end(), static_cast<int>(node));
  return place != nodes.end() && *place == static_cast<int>(node) ? forces[place - nodes.begin()] : Vec2{};
}

void prepare(System& system) {
  const std::size_t slots = 2 * system.contacts.slot_count();
  system.forces.assign(corners_written(system) ? slots + 3 * system.particles.triangle_count() : slots, {});
  if (!system.particles.separate) list_gather(system);
}

Vec2 internal_force(const System& system, std::size_t node) {
  if (corners_written(system)) return gather_force(system, node, system.forces);
  const Particles& p = system.particles;
  const std::size_t t = node / 3, k = node % 3;
  const TriangleShape shape = p.shape(t);
  const Vec2 elastic = corner_forces(shape, triangle_state(p, t))[k];
  const std::vector<int>& slot = system.contacts.slot_of_edge;
  return elastic + system.forces[2 * slot[node]] + system.forces[2 * slot[3 * t + (k + 2) % 3] + 1];
}

double elastic_energy(const Particles& particles, const ParallelLoops& loops) {
  return loops.sum_blocks<double>(particles.triangle_count(), [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t t = begin; t < end; ++t) sum += triangle_energy(particles, t);
    return sum;
  });
}

namespace {

double total_plastic_work(const Particles& particles, const ParallelLoops& loops) {
  if (particles.plasticity.empty()) return 0.0;
  return loops.sum_blocks<double>(particles.triangle_count(), [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t t = begin; t < end; ++t) sum += plastic_work(particles, t);
    return sum;
  });
}

}  // namespace

EnergyBalance energy_balance(const System& system, const ParallelLoops& loops) {
  const ContactEnergies contacts = contact_energies(system.contacts, loops);
  const GeneralContactEnergies general = general_contact_energies(system.general, loops);
  EnergyBalance e;
  e.external_work = system.external_work + system.initial_kinetic;
  e.elastic = elastic_energy(system.particles, loops);
  e.recoverable = contacts.recoverable + general.normal + general.tangential + system.sums.platen_energy;
  e.fracture = contacts.fracture;
  e.plasticity = total_plastic_work(system.particles, loops);
  e.friction = contacts.friction + system.general.friction_energy + system.platen_friction_energy;
  e.damping = system.damping_energy + system.general.damping_energy;
  e.kinetic = system.sums.kinetic;
  e.created_by_law = contacts.created;
  return e;
}

void book_initial_kinetic_energy(System& system) {
  for (std::size_t i = 0; i < system.particles.node_count(); ++i) {
    const Vec2 v = system.particles.velocity[i];
    system.initial_kinetic += 0.5 * system.particles.mass[i] * dot(v, v);
  }
}

}  // namespace asperity
