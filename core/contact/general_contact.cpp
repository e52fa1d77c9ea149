#include "core/contact/general_contact.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/units.hpp"
#include "core/contact/pair_weight.hpp"
#include "core/contact/surface_wear.hpp"
#include "core/contact/touch_entry.hpp"
#include "core/contact/touch_force.hpp"

namespace asperity {
namespace {

/// Eqs. (C40), (C42): the parts of both triangles' edges inside each other, deeper than the seat; false where there are
/// none.
bool overlap(const PresentTriangle& a, const PresentTriangle& b, double stiffening, double seat,
             std::array<EdgePart, 6>& parts) {
  DepthTable b_in_a, a_in_b;
  if (!depth_table(a, b.x, seat, b_in_a) || !depth_table(b, a.x, seat, a_in_b)) return false;
  double inside = 0.0;
  for (int k = 0; k < 3; ++k) {
    parts[k] = edge_part(a_in_b, k, stiffening);
    parts[3 + k] = edge_part(b_in_a, k, stiffening);
    inside += parts[k].m0 + parts[3 + k].m0;
  }
  return inside > 0.0;
}

/// Part of an inradius that counts as room beyond a seat, however deep that is.
constexpr double kLeastRoom = 0.25;

double inradius(const PresentTriangle& t) { return 1.0 / (1.0 / t.height[0] + 1.0 / t.height[1] + 1.0 / t.height[2]); }

/// Whether `other` covers the point of `t` that lies deepest below all its edges.
bool covers_incentre(const PresentTriangle& other, const PresentTriangle& t) {
  Vec2 incentre{};
  for (int k = 0; k < 3; ++k) incentre += (inradius(t) / t.height[k]) * t.x[(k + 2) % 3];
  return other.depth(0, incentre) > 0.0 && other.depth(1, incentre) > 0.0 && other.depth(2, incentre) > 0.0;
}

/// Largest phi anywhere in the overlap of both, mm: on an edge, or where one covers the other's incentre.
double deepest_of(const PresentTriangle& a, const PresentTriangle& b, const std::array<EdgePart, 6>& parts) {
  double deepest = 0.0;
  for (const EdgePart& part : parts) deepest = std::max(deepest, part.deepest);
  if (covers_incentre(b, a)) deepest = std::max(deepest, inradius(a));
  if (covers_incentre(a, b)) deepest = std::max(deepest, inradius(b));
  return deepest;
}

/// I_A + I_B of Eq. (C42), mm3.
double overlap_potentials(const GeneralContacts& general, const MemberPair& pair) {
  const PresentTriangle &a = general.frames[pair.a], &b = general.frames[pair.b];
  return overlap_potential(a, b.x, general.stiffening, pair.seat) +
         overlap_potential(b, a.x, general.stiffening, pair.seat);
}

/// Eq. (C54): where a pair overlaps when it begins to meet; more as the bonds that still hold it let it slip on, less
/// as soon as it overlaps less. Returns the overlap potential (mm3, at weight 1) that yielding gave up.
double seat_pair(const GeneralContacts& general, double weight, MemberPair& pair) {
  if (pair.seat == 0.0 && weight >= kTakenOver) return 0.0;
  const PresentTriangle &a = general.frames[pair.a], &b = general.frames[pair.b];
  std::array<EdgePart, 6> parts;
  if (!overlap(a, b, general.stiffening, 0.0, parts)) {
    pair.seat = kUnseated;
    return 0.0;
  }
  const double deepest = deepest_of(a, b, parts), yielding = std::max(0.0, deepest - general.play);
  if (pair.seat == kUnseated) {
    pair.seat = weight >= kTakenOver && yielding > 0.0 ? deepest : yielding;
    return 0.0;
  }
  if (weight >= kTakenOver || yielding <= pair.seat) {
    pair.seat = std::min(pair.seat, deepest);
    return 0.0;
  }
  const double before = overlap_potentials(general, pair);
  pair.seat = yielding;
  return before - overlap_potentials(general, pair);
}

/// Brings the touches of pairs [begin, end) up to date and marks them alive; returns those that begin, in order.
std::vector<Touch> update_touches(GeneralContacts& general, const BondedContacts& bonded, std::size_t begin,
                                  std::size_t end) {
  std::vector<Touch> begun;
  std::array<EdgePart, 6> parts;
  for (std::size_t p = begin; p < end; ++p) {
    MemberPair& pair = general.pairs[p];
    const double weight = pair_weight(general, bonded, pair);
    if (weight <= 0.0) continue;
    const double yielded = seat_pair(general, weight, pair);
    if (pair.seat == kUnseated) continue;
    if (!overlap(general.frames[pair.a], general.frames[pair.b], general.stiffening, pair.seat, parts)) continue;
    if (pair.touch < 0) begun.emplace_back().pair = static_cast<int>(p);
    Touch& touch = pair.touch < 0 ? begun.back() : general.touches[pair.touch];
    touch.weight = weight;
    touch.yielded = pair.touch < 0 ? 0.0 : yielded;
    touch.handing_over = pair.chain_size > 0;
    touch.parts = parts;
    if (pair.touch >= 0) general.alive[pair.touch] = 1;
  }
  return begun;
}

std::vector<Touch> update_touches(GeneralContacts& general, const BondedContacts& bonded, const ParallelLoops& loops) {
  general.alive.assign(general.touches.size(), 0);
  std::vector<std::vector<Touch>> blocks((general.pairs.size() + ParallelLoops::kBlock - 1) / ParallelLoops::kBlock);
  loops.for_blocks(general.pairs.size(), [&](std::size_t begin, std::size_t end) {
    blocks[begin / ParallelLoops::kBlock] = update_touches(general, bonded, begin, end);
  });
  std::vector<Touch> begun;
  for (const auto& block : blocks) begun.insert(begun.end(), block.begin(), block.end());
  return begun;
}

/// Takes the touches that are not alive off the list, whose order then follows from what happened alone.
std::vector<Touch> remove_ended(GeneralContacts& general) {
  std::vector<Touch> ended;
  for (std::size_t t = general.touches.size(); t-- > 0;) {
    if (general.alive[t]) continue;
    ended.push_back(general.touches[t]);
    general.pairs[general.touches[t].pair].touch = -1;
    if (t + 1 < general.touches.size()) {
      general.touches[t] = general.touches.back();
      general.pairs[general.touches[t].pair].touch = static_cast<int>(t);
    }
    general.touches.pop_back();
  }
  return ended;
}

void append_begun(GeneralContacts& general, const std::vector<Touch>& begun) {
  for (const Touch& touch : begun) {
    general.pairs[touch.pair].touch = static_cast<int>(general.touches.size());
    general.touches.push_back(touch);
    fix_penalties(general, general.touches.back());
  }
}

/// Enters all changes of contact length in the ledger.
void enter_changes(GeneralContacts& general, const std::vector<Touch>& ended) {
  general.ledger.start(3 * general.members.size());
  for (const Touch& touch : general.touches) {
    for (int i = 0; i < 6; ++i) {
      const EdgeFriction& f = touch.friction[i];
      if (f.length == 0.0 && touch.parts[i].m0 == 0.0) continue;
      const Entry entry = entry_of(general.pairs[touch.pair], i);
      if (!is_exposed(general, entry)) continue;
      general.ledger.change(entry.edge(), f.length, effective_length(general, touch, entry, i), f.slip);
    }
  }
  for (const Touch& touch : ended) {
    for (int i = 0; i < 6; ++i) {
      const EdgeFriction& f = touch.friction[i];
      general.ledger.change(entry_of(general.pairs[touch.pair], i).edge(), f.length, 0.0, f.slip);
    }
  }
  general.ledger.settle(general.members);
}

/// Potential of a pair at weight 1, Eq. (C42).
double pair_potential(const GeneralContacts& general, const Touch& touch) {
  return 0.5 * touch.k_n * overlap_potentials(general, general.pairs[touch.pair]);
}

/// Forces of all touches, added to those of the triangles' corners.
void press(GeneralContacts& general, const Particles& particles, double time_step, std::vector<Touch>& ended,
           const ParallelLoops& loops, const ForceSlots& forces) {
  general.forces.resize(general.touches.size());
  const TouchContext context{general, particles, time_step};
  StepLosses losses = loops.sum_blocks<StepLosses>(general.touches.size(), [&](std::size_t begin, std::size_t end) {
    StepLosses sum;
    for (std::size_t t = begin; t < end; ++t) general.forces[t] = touch_force(context, general.touches[t], sum);
    return sum;
  });
  for (Touch& touch : ended) end_touch(context, touch, losses);
  general.friction_energy += losses.friction;
  general.damping_energy += losses.damping;
  general.largest_depth = std::max(general.largest_depth, losses.deepest);
  general.largest_depth_handing_over = std::max(general.largest_depth_handing_over, losses.deepest_handing_over);
  general.largest_seat = std::max(general.largest_seat, losses.deepest_seat);
  for (std::size_t t = 0; t < general.touches.size(); ++t) {
    const MemberPair& pair = general.pairs[general.touches[t].pair];
    const int a = 3 * general.members[pair.a].triangle, b = 3 * general.members[pair.b].triangle;
    for (int i = 0; i < 3; ++i) {
      forces.on_corner(a + i) += general.forces[t][i];
      forces.on_corner(b + i) += general.forces[t][3 + i];
    }
  }
}

/// Eq. (C48) for every bonded contact that is handing over.
void hand_over(GeneralContacts& general, const BondedContacts& bonded, const Particles& particles,
               const ForceSlots& forces) {
  general.set_free.resize(bonded.size());
  for (int c : general.handing_over) general.set_free[c] = 0.0;
  for (const Touch& touch : general.touches) {
    if (!touch.handing_over) continue;
    share_potential(general, bonded, general.pairs[touch.pair], pair_potential(general, touch), general.set_free);
  }
  for (int c : general.handing_over) {
    if (bonded.weight(c) == 0.0) continue;
    add_hand_over_force(bonded, c, general.set_free[c], particles.position, forces.all);
  }
}

}  // namespace

GeneralContactLaw general_contact_law(const RunConfig& config, const LawParameters& law) {
  const auto surface = [&](const SurfaceConfig& s, const FrictionWear& wear) -> SurfaceLaw {
    const double tan_phi = s.friction_angle_deg ? std::tan(*s.friction_angle_deg * units::kRadPerDeg) : law.tan_phi;
    const double k_n = s.normal_stiffness_mpa_per_mm.value_or(law.k_t);
    return {tan_phi, k_n, s.shear_stiffness_mpa_per_mm.value_or(law.k_s), wear};
  };
  const auto bent = [&](SurfaceLaw s) {
    s.exponent = law.envelope_exponent;
    s.bend = law.tan_phi_peak / (law.envelope_exponent * law.c_c);
    return s;
  };
  const GeneralContactConfig& general = config.contacts.general;
  const std::array surfaces{surface(general.outline, config.extensions.outline_wear),
                            bent(surface(general.fracture, config.extensions.fracture_wear))};
  return {general.enabled, surfaces, general.damping_ratio};
}

void update_frames(GeneralContacts& general, const Particles& particles, const ParallelLoops& loops) {
  general.frames.resize(general.members.size());
  loops.for_blocks(general.members.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t m = begin; m < end; ++m) {
      const int t = general.members[m].triangle;
      general.frames[m] = present_triangle(particles.shape(t), particles.corners(t));
    }
  });
}

void update_general_contacts(GeneralContacts& general, const BondedContacts& bonded, const Particles& particles,
                             double time_step, const ParallelLoops& loops, const ForceSlots& forces) {
  if (!general.law.enabled) return;
  if (general.search_due || general.travel > 0.5 * general.skin) search_pairs(general, bonded, particles, loops);
  if (general.pairs.empty()) return;
  update_frames(general, particles, loops);
  const std::vector<Touch> begun = update_touches(general, bonded, loops);
  std::vector<Touch> ended = remove_ended(general);
  append_begun(general, begun);
  enter_changes(general, ended);
  press(general, particles, time_step, ended, loops, forces);
  add_wear(general);
  hand_over(general, bonded, particles, forces);
}

GeneralContactEnergies general_contact_energies(const GeneralContacts& general, const ParallelLoops& loops) {
  return loops.sum_blocks<GeneralContactEnergies>(general.touches.size(), [&](std::size_t begin, std::size_t end) {
    GeneralContactEnergies sum;
    for (std::size_t t = begin; t < end; ++t) {
      const Touch& touch = general.touches[t];
      sum.normal += touch.weight * pair_potential(general, touch);
      for (const EdgeFriction& f : touch.friction) sum.tangential += 0.25 * touch.k_s * f.length * f.slip * f.slip;
    }
    return sum;
  });
}

DeepestTouch deepest_touch(const GeneralContacts& general) {
  DeepestTouch deepest;
  for (const Touch& touch : general.touches) {
    if (touch.weight < kTakenOver) continue;
    for (int i = 0; i < 6; ++i) {
      const Entry entry = entry_of(general.pairs[touch.pair], i);
      if (!is_exposed(general, entry)) continue;
      const double radius = inradius(general.frames[entry.other]);
      const double room = std::max(radius - general.pairs[touch.pair].seat, kLeastRoom * radius);
      const double share = touch.parts[i].deepest / room;
      if (share > deepest.share) deepest = {share, general.frames[entry.own].x[entry.k]};
    }
  }
  return deepest;
}

std::vector<TouchForce> touch_forces(const GeneralContacts& general) {
  std::vector<TouchForce> result;
  for (const Touch& touch : general.touches) {
    const MemberPair& pair = general.pairs[touch.pair];
    Vec2 normal, shear, moment;
    double weight = 0.0;
    for (int i = 0; i < 6; ++i) {
      const EdgePart& part = touch.parts[i];
      if (part.m0 <= 0.0) continue;
      const Entry entry = entry_of(pair, i);
      const PresentTriangle &own = general.frames[entry.own], &other = general.frames[entry.other];
      const TouchPoint point = touch_point(own, other, entry.k, part);
      const double force =
          0.5 * touch.weight * touch.k_n * other.inverse_jacobian * edge_length(own, entry.k) * part.m0;
      const double sign = i < 3 ? 1.0 : -1.0;
      normal += (sign * force) * point.normal();
      shear += (sign * 0.5 * touch.k_s * touch.friction[i].length * touch.friction[i].slip) * point.tangent;
      moment += force * position_on_edge(own, entry.k, point.s);
      weight += force;
    }
    result.push_back({general.members[pair.a].triangle, general.members[pair.b].triangle, (1.0 / weight) * moment,
                      norm(normal), norm(shear)});
  }
  return result;
}

}  // namespace asperity
