#include "core/measurement/contact_forces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace asperity {
namespace {

constexpr double kNegligible = 1e-9;  // of the frame's largest force: rounding, not load

/// Number of what a force ends at: a particle, or one triangle of a joint's elastic part, whose middle lies far away.
int particle_of(const Particles& p, std::size_t triangle) {
  const bool elastic = !p.in_bulk.empty() && p.in_bulk[triangle];
  return elastic ? static_cast<int>(p.triangle_count() + triangle) : p.grain[triangle];
}

/// What the contact edges between two particles add up to, forces in N.
struct PairForce {
  int left_particle = 0, right_particle = 0;
  double normal_n = 0, shear_n = 0;  ///< Compression positive; shear with its sign.
  double length_mm = 0;
  Vec2 moment_of_length;  ///< Sum of the edges' middles times their lengths, mm2.
  bool bonded = false;
};

/// Eq. (M12). Normal and shear traction keep their signs when left and right are exchanged, so edges can be added.
void add_edge(PairForce& pair, const BondedContacts& contacts, std::size_t c, const Particles& p, double thickness_mm) {
  const ContactEdge& e = contacts.edges[c];
  const double area = 0.5 * e.length * thickness_mm;
  for (const PointState& point : contacts.points(c)) {
    pair.normal_n -= area * point.traction_n;
    pair.shear_n += area * point.traction_s;
  }
  const Vec2 middle = 0.25 * (p.position[e.left1] + p.position[e.left2] + p.position[e.right1] + p.position[e.right2]);
  pair.length_mm += e.length;
  pair.moment_of_length += e.length * middle;
  pair.bonded = pair.bonded || !contacts.is_broken(c);
}

std::vector<PairForce> pair_forces(const BondedContacts& contacts, const Particles& p, double thickness_mm) {
  std::map<std::pair<int, int>, std::size_t> place;
  std::vector<PairForce> pairs;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const int left = particle_of(p, contacts.edges[c].left_triangle());
    const int right = particle_of(p, contacts.edges[c].right_triangle());
    const auto [entry, is_new] = place.try_emplace(std::minmax(left, right), pairs.size());
    if (is_new) pairs.push_back({left, right, 0, 0, 0, {}, false});
    add_edge(pairs[entry->second], contacts, c, p, thickness_mm);
  }
  return pairs;
}

ContactForce to_contact(const PairForce& pair, const std::vector<Vec2>& centre) {
  return {centre[pair.left_particle],
          centre[pair.right_particle],
          (1.0 / pair.length_mm) * pair.moment_of_length,
          pair.normal_n,
          std::abs(pair.shear_n),
          pair.bonded ? ContactKind::bonded : ContactKind::broken};
}

double size_of(const PairForce& pair) { return std::hypot(pair.normal_n, pair.shear_n); }

}  // namespace

std::vector<Vec2> particle_centres(const Particles& p) {
  std::vector<Vec2> centre;
  std::vector<double> area;
  for (std::size_t t = 0; t < p.triangle_count(); ++t) {
    const std::size_t particle = static_cast<std::size_t>(particle_of(p, t));
    if (particle >= centre.size()) {
      centre.resize(particle + 1);
      area.resize(particle + 1, 0.0);
    }
    const auto [a, b, c] = p.corners(t);
    centre[particle] += (p.shape(t).area / 3.0) * (a + b + c);
    area[particle] += p.shape(t).area;
  }
  for (std::size_t i = 0; i < centre.size(); ++i) {
    if (area[i] > 0.0) centre[i] = (1.0 / area[i]) * centre[i];
  }
  return centre;
}

std::vector<ContactForce> bonded_contact_forces(const BondedContacts& contacts, const Particles& particles,
                                                double thickness_mm) {
  const std::vector<PairForce> pairs = pair_forces(contacts, particles, thickness_mm);
  double largest = 0;
  for (const PairForce& pair : pairs) largest = std::max(largest, size_of(pair));
  const std::vector<Vec2> centre = particle_centres(particles);
  std::vector<ContactForce> forces;
  for (const PairForce& pair : pairs) {
    if (size_of(pair) > kNegligible * largest) forces.push_back(to_contact(pair, centre));
  }
  return forces;
}

std::vector<ContactForce> general_contact_forces(const GeneralContacts& general, const Particles& p,
                                                 double thickness_mm) {
  std::vector<ContactForce> forces;
  if (general.touches.empty()) return forces;
  const std::vector<Vec2> centre = particle_centres(p);
  for (const TouchForce& touch : touch_forces(general)) {
    forces.push_back({centre[particle_of(p, touch.triangle_a)], centre[particle_of(p, touch.triangle_b)], touch.point,
                      touch.normal * thickness_mm, touch.shear * thickness_mm, ContactKind::general});
  }
  return forces;
}

}  // namespace asperity
