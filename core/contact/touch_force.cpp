#include "core/contact/touch_force.hpp"

#include <algorithm>
#include <cmath>

#include "core/contact/surface_wear.hpp"
#include "core/contact/touch_entry.hpp"

namespace asperity {
namespace {

/// How an entry moved in the last step: its own point relative to the other triangle, mm, along the old point's tangent
/// and normal (where the old forces did their last work) and along the present ones.
struct EntryMotion {
  double old_slip = 0, old_approach = 0;
  double slip = 0, approach = 0;
};

/// Force against the slip, and how far an entry slid for good, mm.
struct Rubbing {
  double force = 0, slid = 0;
};

/// Coulomb friction with elastic slip, Eqs. (C47)-(C49); a length of zero ends the contact. Books what is spent.
Rubbing rub(EdgeFriction& f, double length, double incoming_slip, const EntryMotion& motion, double stiffness,
            double limit, StepLosses& losses) {
  const double energy = 0.5 * stiffness * f.length * f.slip * f.slip;
  const double before = stiffness * f.length * f.slip;
  if (length > f.length) f.slip = (f.length * f.slip + (length - f.length) * incoming_slip) / length;
  f.length = length;
  const double total = stiffness * length;
  const double start = total * f.slip;
  losses.friction += energy - 0.5 * start * f.slip + 0.5 * (before * motion.old_slip - start * motion.slip);
  if (length <= 0.0) {
    f.slip = 0.0;
    return {};
  }
  const double trial = start + total * motion.slip;
  const double force = std::clamp(trial, -limit, limit);
  losses.friction += std::max(0.0, 0.5 * (start + force) * (trial - force)) / total;
  f.slip = force / total;
  return {force, std::abs(trial - force) / total};
}

/// Viscous force on the approach, Eq. (C50); never pulls.
double damp(EdgeFriction& f, const EntryMotion& motion, double time_step, double coefficient, double normal,
            StepLosses& losses) {
  const double force = std::max(coefficient * motion.approach / time_step, -normal);
  losses.damping += 0.5 * (f.damping * motion.old_approach + force * motion.approach);
  f.damping = force;
  return force;
}

double mean_node_mass(const Particles& p, int triangle) {
  double mass = 0.0;
  for (int node : p.triangles[triangle]) mass += p.mass[node] / 3.0;
  return mass;
}

/// Reduced mass of one corner of each of two triangles, tonne per mm of thickness.
double reduced_mass(const Particles& p, int a, int b) {
  const double ma = mean_node_mass(p, a), mb = mean_node_mass(p, b);
  return ma * mb / (ma + mb);
}

/// Displacement of the own edge's point relative to the other triangle's in the last step, mm.
Vec2 relative_motion(const TouchContext& c, const Entry& entry, const TouchPoint& point) {
  const auto& v = c.particles.velocity;
  const auto& own = c.particles.triangles[c.general.members[entry.own].triangle];
  const auto& other = c.particles.triangles[c.general.members[entry.other].triangle];
  Vec2 motion = (1.0 - point.s) * v[own[entry.k]] + point.s * v[own[(entry.k + 1) % 3]];
  for (int i = 0; i < 3; ++i) motion -= point.share[i] * v[other[i]];
  return c.time_step * motion;
}

EntryMotion old_motion(const TouchContext& c, const Entry& entry, const EdgeFriction& f) {
  if (f.length == 0.0) return {};
  const Vec2 motion = relative_motion(c, entry, f.point);
  return {dot(motion, f.point.tangent), dot(motion, f.point.normal()), 0.0, 0.0};
}

/// Force of entry i on its own edge, Eqs. (C43), (C47), (C50).
Vec2 entry_force(const TouchContext& c, Touch& touch, int i, const Entry& entry, const TouchPoint& point,
                 StepLosses& losses) {
  const PresentTriangle &own = c.general.frames[entry.own], &other = c.general.frames[entry.other];
  const double edge = edge_length(own, entry.k);
  const double normal = 0.5 * touch.weight * touch.k_n * other.inverse_jacobian * edge * touch.parts[i].m0;
  if (!is_exposed(c.general, entry)) return (-normal) * point.normal();
  double& deepest = touch.weight >= kTakenOver ? losses.deepest : losses.deepest_handing_over;
  deepest = std::max(deepest, touch.parts[i].deepest);
  losses.deepest_seat = std::max(losses.deepest_seat, c.general.pairs[touch.pair].seat);
  EdgeFriction& f = touch.friction[i];
  EntryMotion motion = old_motion(c, entry, f);
  const Vec2 moved = relative_motion(c, entry, point);
  motion.slip = dot(moved, point.tangent);
  motion.approach = dot(moved, point.normal());
  const SurfaceLaw law = surface_law(c.general, entry, position_on_edge(own, entry.k, point.s));
  const double length = effective_length(c.general, touch, entry, i);
  const Rubbing rubbing = rub(f, length, c.general.ledger.incoming(entry.edge()), motion, 0.5 * touch.k_s,
                              friction_limit(law, normal, length), losses);
  if (!c.general.wear.empty()) f.wear = wear_of_slip(own_surface(c.general, entry).wear, rubbing.slid, normal, length);
  double pressing = normal;
  if (c.general.law.damping_ratio > 0.0) {
    const double mass =
        reduced_mass(c.particles, c.general.members[entry.own].triangle, c.general.members[entry.other].triangle);
    const double critical = 2.0 * std::sqrt(0.5 * touch.k_n * edge * mass) / edge;
    pressing += damp(f, motion, c.time_step, c.general.law.damping_ratio * critical * length, normal, losses);
  }
  f.point = point;
  return (-pressing) * point.normal() - rubbing.force * point.tangent;
}

/// Books what an entry still held, and did over half of the last step, when it lost its contact.
void end_entry(const TouchContext& c, Touch& touch, int i, const Entry& entry, StepLosses& losses) {
  EdgeFriction& f = touch.friction[i];
  if (f.length == 0.0) return;
  const EntryMotion motion = old_motion(c, entry, f);
  rub(f, 0.0, 0.0, motion, 0.5 * touch.k_s, 0.0, losses);
  losses.damping += 0.5 * f.damping * motion.old_approach;
  f.damping = 0.0;
}

}  // namespace

PairForces touch_force(const TouchContext& c, Touch& touch, StepLosses& losses) {
  PairForces forces;
  losses.friction += 0.5 * touch.k_n * touch.weight * touch.yielded;
  for (int i = 0; i < 6; ++i) {
    const Entry entry = entry_of(c.general.pairs[touch.pair], i);
    if (touch.parts[i].m0 <= 0.0) {
      end_entry(c, touch, i, entry, losses);
      continue;
    }
    const TouchPoint point =
        touch_point(c.general.frames[entry.own], c.general.frames[entry.other], entry.k, touch.parts[i]);
    const Vec2 force = entry_force(c, touch, i, entry, point, losses);
    const int own = i < 3 ? 0 : 3, other = 3 - own;
    forces[own + entry.k] += (1.0 - point.s) * force;
    forces[own + (entry.k + 1) % 3] += point.s * force;
    for (int j = 0; j < 3; ++j) forces[other + j] -= point.share[j] * force;
  }
  return forces;
}

void end_touch(const TouchContext& c, Touch& touch, StepLosses& losses) {
  for (int i = 0; i < 6; ++i) end_entry(c, touch, i, entry_of(c.general.pairs[touch.pair], i), losses);
}

}  // namespace asperity
