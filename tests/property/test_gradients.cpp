#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/models.hpp"

using namespace asperity;

namespace {

/// Recoverable energy of a virgin copy of the contacts brought to the given positions; forces too where asked.
double contact_energy(BondedContacts contacts, const std::vector<Vec2>& x, std::vector<Vec2>* forces = nullptr) {
  const ParallelLoops loops;
  std::vector<Vec2> scratch(2 * contacts.slot_count());
  update_contacts(contacts, x, 0.0, loops, scratch);
  if (forces) *forces = scratch;
  return contact_energies(contacts, loops).recoverable;
}

std::vector<Vec2> nodal(const BondedContacts& contacts, const std::vector<Vec2>& forces, std::size_t nodes) {
  std::vector<Vec2> sum(nodes);
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const ContactEdge& e = contacts.edges[c];
    const int ends[4] = {e.left1, e.left2, e.right2, e.right1};  // in the order of ContactNode
    for (std::size_t i = 0; i < 4; ++i) sum[ends[i]] += forces[force_index(c, static_cast<ContactNode>(i))];
  }
  return sum;
}

template <class Energy>
Vec2 difference(std::vector<Vec2>& x, std::size_t node, double h, const Energy& energy) {
  Vec2 gradient;
  for (double Vec2::*axis : {&Vec2::x, &Vec2::y}) {
    const double middle = x[node].*axis;
    x[node].*axis = middle + h;
    const double above = energy(x);
    x[node].*axis = middle - h;
    gradient.*axis = (above - energy(x)) / (2.0 * h);
    x[node].*axis = middle;
  }
  return gradient;
}

std::vector<Vec2> turned_and_shaken(const Particles& p, double angle, double shake) {
  RandomStream random(5, "gradients");
  std::vector<Vec2> x;
  for (const int v : p.vertex) {
    const Vec2 r = p.vertices[v];
    const Vec2 noise{random.uniform(-shake, shake), random.uniform(-shake, shake)};
    x.push_back(test::turned(r, angle) + noise);
  }
  return x;
}

}  // namespace

TEST_CASE("Contact forces are the gradient of the recoverable energy, gaps and rotations finite") {
  // A law that stays linear: gaps of a tenth of an edge then test the couple that the rotating midline frame needs.
  const System system = test::make_system(test::grid_mesh({2, 2}), test::plaster(), test::unbreakable_law());
  std::vector<Vec2> x = turned_and_shaken(system.particles, GENERATE(0.0, 0.7, 2.6), 0.2), forces;
  contact_energy(system.contacts, x, &forces);
  const auto force = nodal(system.contacts, forces, x.size());
  double worst = 0.0, largest = 0.0;
  for (std::size_t node = 0; node < x.size(); ++node) {
    const Vec2 slope = difference(x, node, 1e-5, [&](const auto& y) { return contact_energy(system.contacts, y); });
    worst = std::max(worst, norm(force[node] + slope));
    largest = std::max(largest, norm(force[node]));
  }
  // Truncation (h / edge)^2 = 1e-10, rounding 1e-16 / (h / gap) = 1e-12; the law's own exp(-1e-9) is 1e-9 off linear.
  CHECK(worst < 1e-7 * largest);
}

TEST_CASE("Triangle forces are the gradient of the elastic energy under finite rotation and strain") {
  const System system = test::make_system(test::grid_mesh({1, 1}));
  const double angle = GENERATE(0.0, 1.1, 3.0);
  Particles p = system.particles;
  std::vector<Vec2> x = turned_and_shaken(p, angle, 0.2);
  const auto energy = [&](const std::vector<Vec2>& y) {
    p.position = y;
    return triangle_energy(p, 0);
  };
  energy(x);
  const auto force = corner_forces(p.shape(0), biot_state(deformation_gradient(p.shape(0), p.corners(0)), p.elastic));
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 slope = difference(x, static_cast<std::size_t>(p.triangles[0][i]), 1e-5, energy);
    CHECK(norm(force[i] + slope) < 1e-7 * norm(force[i]));  // truncation (h / edge)^2 = 1e-10, rounding 1e-11
  }
}

TEST_CASE("Forces of a triangle with plastic strain are the gradient of its energy, and turn nothing") {
  const System system = test::make_system(test::grid_mesh({1, 1}));
  Particles p = system.particles;
  set_yield_stress(p, 1.0);
  p.plasticity[0].difference[0] = 0.07;
  p.plasticity[0].shear[0] = -0.11;
  std::vector<Vec2> x = turned_and_shaken(p, GENERATE(0.0, 1.1, 3.0), 0.2);
  const auto energy = [&](const std::vector<Vec2>& y) {
    p.position = y;
    return triangle_energy(p, 0);
  };
  energy(x);
  const auto force = corner_forces(p.shape(0), triangle_state(p, 0));
  double moment = 0.0, arm = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto node = static_cast<std::size_t>(p.triangles[0][i]);
    const Vec2 slope = difference(x, node, 1e-5, energy);
    CHECK(norm(force[i] + slope) < 1e-7 * norm(force[i]));  // as above
    moment += cross(x[node] - x[static_cast<std::size_t>(p.triangles[0][0])], force[i]);
    arm += norm(force[i]);
  }
  CHECK(std::abs(moment) < 1e-12 * arm);
}
